#pragma once
/// \file
/// Columns in which the unit changes without a word, or cannot be what the header says.

#include <mdm/number/rational.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// The index where micrometres begin or end, of sizes in the order of their rows: from 4.75, 2.36, 1.18 the
/// next sieve is 600, or from 63, 150, 300 it is 1.18. Nothing where all may have one unit.
std::optional<std::size_t> unit_break(const std::vector<Rational> &sizes);

/// True where sizes in mm are those of sieves in um: none is below 20 and the largest is above 125, beyond
/// which no series of test sieves goes.
bool may_be_micrometres(const std::vector<Rational> &sizes);

} // namespace mdm
