#include "gradation/unit_break.hpp"

#include <algorithm>

namespace mdm {
namespace {

constexpr int finest_sieve_um = 20, widest_sieve_mm = 125; // of ISO 565

/// Where micrometres begin among sizes from the coarsest on. The finest sieve that is named in mm is at most
/// 6, and those in micrometres are finer whole numbers from 20 to 999.
std::optional<std::size_t> break_from_coarsest(const std::vector<Rational> &sizes) {
  const auto above = [](const Rational &a, const Rational &b) { return a < b; };
  const auto rise = std::adjacent_find(sizes.begin(), sizes.end(), above);
  if (rise == sizes.end())
    return std::nullopt;
  const auto um = rise + 1;
  const bool has_one_rise = std::adjacent_find(um, sizes.end(), above) == sizes.end();
  const bool are_micrometres = std::all_of(um, sizes.end(), [](const Rational &size) {
    return size == 0 || (denominator(size) == 1 && size >= 20 && size < 1000);
  });
  if (!has_one_rise || !are_micrometres || 1000 * *rise <= *um || *rise > 6)
    return std::nullopt;
  return static_cast<std::size_t>(um - sizes.begin());
}

} // namespace

std::optional<std::size_t> unit_break(const std::vector<Rational> &sizes) {
  if (const std::optional<std::size_t> at = break_from_coarsest(sizes))
    return at;
  const std::optional<std::size_t> at = break_from_coarsest({sizes.rbegin(), sizes.rend()});
  return at ? std::optional(sizes.size() - *at) : std::nullopt;
}

bool may_be_micrometres(const std::vector<Rational> &sizes) {
  const Rational four_phi = ratio(125, 2); // in micrometres
  const auto is_sieve = [&four_phi](const Rational &size) {
    return (denominator(size) == 1 && size >= finest_sieve_um) || size == four_phi;
  };
  return std::all_of(sizes.begin(), sizes.end(),
                     [&is_sieve](const Rational &size) { return size == 0 || is_sieve(size); }) &&
         std::any_of(sizes.begin(), sizes.end(), [](const Rational &size) { return size > widest_sieve_mm; });
}

} // namespace mdm
