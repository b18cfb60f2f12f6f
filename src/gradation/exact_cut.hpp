#pragma once
/// \file
/// Where a gradation can be cut in two exactly.

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// The number of classes that are at or below `size`, a sieve of g or a size in a class without mass: all
/// other classes with mass are above it.
/// \param where  what the cut is for messages, such as `the joint`
/// \throws InputError naming the sieves around `size` where the class around it holds mass
std::size_t classes_below(const Gradation &g, const Rational &size, const char *where);

/// The mass of the classes `from`, ..., `to` - 1.
Rational mass_of(const Gradation &g, std::size_t from, std::size_t to);

} // namespace mdm
