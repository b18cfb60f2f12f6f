#pragma once
/// \file
/// Series of sieves.

#include <mdm/number/rational.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The openings of a series in mm, ascending: `ISO R20/3`, the principal sizes of ISO 3310-1, `ISO R20`,
/// `ASTM E11` and `Tyler`, as their names are read (sieve_name.hpp), or `phi`, `half-phi` and `quarter-phi`:
/// 2^-phi for phi from -7 to 14, to 15 digits.
/// \throws InputError for any other name
std::vector<Rational> sieve_series(const std::string &name);

} // namespace mdm
