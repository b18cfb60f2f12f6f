#include "gradation/sieve_order.hpp"

#include <algorithm>
#include <functional>

namespace mdm {
namespace {

bool fall(const std::vector<Rational> &sizes) {
  return std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>()) == sizes.end();
}

bool fall_without(std::vector<Rational> sizes, std::ptrdiff_t row) {
  sizes.erase(sizes.begin() + row);
  return fall(sizes);
}

/// The one row without which sizes fall that do not fall with it.
std::optional<std::ptrdiff_t> out_of_falling(const std::vector<Rational> &sizes) {
  const auto upper = std::adjacent_find(sizes.begin(), sizes.end(), std::less_equal<>());
  const std::ptrdiff_t row = upper - sizes.begin();
  const bool is_upper = fall_without(sizes, row), is_lower = fall_without(sizes, row + 1);
  if (is_upper == is_lower)
    return std::nullopt;
  return is_upper ? row : row + 1;
}

} // namespace

std::optional<std::size_t> out_of_order(const std::vector<Rational> &sizes) {
  if (sizes.size() < 5 || fall(sizes))
    return std::nullopt;
  const std::vector<Rational> upwards(sizes.rbegin(), sizes.rend());
  if (fall(upwards))
    return std::nullopt;
  if (const std::optional<std::ptrdiff_t> row = out_of_falling(sizes))
    return static_cast<std::size_t>(*row);
  const std::optional<std::ptrdiff_t> row = out_of_falling(upwards);
  return row ? std::optional(sizes.size() - 1 - static_cast<std::size_t>(*row)) : std::nullopt;
}

} // namespace mdm
