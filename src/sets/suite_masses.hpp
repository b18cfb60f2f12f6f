#pragma once
/// \file
/// The masses of a line of a suite.

#include "sets/suite_description.hpp"

namespace mdm {

/// A mass for each class between the openings. But for ties they are percentages, multiples of 10^(2 -
/// digits) that sum to 100.
std::vector<Rational> drawn_masses(const SuiteMasses &kind, const std::vector<Rational> &openings,
                                   unsigned digits, RandomStream &random);

} // namespace mdm
