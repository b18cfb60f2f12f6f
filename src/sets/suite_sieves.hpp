#pragma once
/// \file
/// The sieves of a line of a suite.

#include "sets/suite_description.hpp"

namespace mdm {

/// `classes` + 1 openings, ascending.
std::vector<Rational> drawn_openings(const ListedSieves &sieves, std::uint32_t classes, RandomStream &random);
std::vector<Rational> drawn_openings(const GeometricSieves &sieves, std::uint32_t classes,
                                     RandomStream &random);

} // namespace mdm
