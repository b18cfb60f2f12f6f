#pragma once
/// \file
/// The order of a table's sieves.

#include <mdm/number/rational.hpp>

#include <cstddef>
#include <optional>
#include <vector>

namespace mdm {

/// The one row without which sizes fall, or grow, from row to row, as a size with a wrong digit is; nothing
/// where they do with it, where no row or more than one is such, and of fewer than five rows.
/// Cost: n comparisons.
std::optional<std::size_t> out_of_order(const std::vector<Rational> &sizes);

} // namespace mdm
