#pragma once
/// \file
/// The classes of a problem whose masses are rational at the openings.

#include "match/problem.hpp"

#include <string_view>

namespace mdm {

/// A class in integers, to the power 1: q f < s mass <= q F.
struct LinearClass {
  std::size_t index; ///< class of the gradation, from 0
  Integer f, F, mass, floor;
};

/// The classes of a problem, ascending, in one unit of mass.
/// \param form  what needs rational numbers, for the message
/// \throws InputError if the law is irrational at an opening
std::vector<LinearClass> linear_classes(const Problem &problem, std::string_view form);

} // namespace mdm
