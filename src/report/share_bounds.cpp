#include "report/share_bounds.hpp"

#include "report/interval_json.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// True if y lies within the bounds, nothing if that is open.
std::optional<bool> lies_within(const Interval &y, const ShareBounds &bounds) {
  if (y.lo >= bounds.lo && y.hi <= bounds.hi)
    return true;
  if (y.hi < bounds.lo || y.lo > bounds.hi)
    return false;
  return std::nullopt;
}

/// Keeps all bounds that are broken, or else all that are open.
void note(BoundsVerdict &verdict, std::optional<bool> holds, const std::string &reason) {
  const bool is_worse = (holds == false && verdict.holds != false) || (!holds && verdict.holds == true);
  if (is_worse)
    verdict = {holds, reason};
  else if (holds != true && holds == verdict.holds)
    verdict.reason += "; " + reason;
}

std::string percent_text(const Rational &share, unsigned digits) {
  return approximate(Rational(100 * share), digits);
}

std::string outside_text(const std::string &what, const Interval &found, const ShareBounds &bounds,
                         unsigned digits) {
  digits = digits_apart(found.lo, bounds.lo, digits_apart(found.lo, bounds.hi, digits));
  return fmt::format("{} is {} %, and the limits are {} and {} %", what, percent_text(found.lo, digits),
                     percent_text(bounds.lo, digits), percent_text(bounds.hi, digits));
}

} // namespace

BoundsVerdict check_bounds(const Tolerance &bounds, const MatchError &e, const Gradation &g,
                           unsigned digits) {
  BoundsVerdict verdict{true, ""};
  for (std::size_t j = 0; j < bounds.retained.size(); ++j)
    note(verdict, lies_within(e.shares[j], bounds.retained[j]),
         outside_text(fmt::format("the share of class {}", j + 1), e.shares[j], bounds.retained[j], digits));
  Interval passing;
  for (std::size_t j = 0; j + 1 < g.classes() && j < bounds.passing.size();
       ++j) { // all passes the last sieve
    passing = {passing.lo + e.shares[j].lo, std::min(Rational(1), Rational(passing.hi + e.shares[j].hi))};
    note(verdict, lies_within(passing, bounds.passing[j]),
         outside_text(fmt::format("what passes {} {}", g.opening_text(j + 1), name(g.unit())), passing,
                      bounds.passing[j], digits));
  }
  if (bounds.total) {
    const ShareBounds most{0, *bounds.total};
    const unsigned apart = digits_apart(e.total.lo, most.hi, digits);
    note(verdict, lies_within(e.total, most),
         fmt::format("the errors of all shares sum to {} %, and the limit is {} %",
                     percent_text(e.total.lo, apart), percent_text(most.hi, apart)));
  }
  return verdict;
}

} // namespace mdm
