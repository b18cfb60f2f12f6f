// The least number N of particles whose shares by number are exact or within a tolerance (Theorem 27).
//
// In comes a gradation whose masses are shares by number; over their least common denominator S they are
// integers M_j with sum S, and S particles have the exact shares: fewer have not. Within a tolerance, each N
// from 1 on is looked at until one serves; S does, so the search ends. Retained and passing: the numbers q_1
// + ... + q_j that classes 1 to j can have are all the integers of an interval, which the bounds of class j
// make of the one before. A total: the least sum of deviations has the numbers rounded by largest remainders.
// All in integers.

#include "match/number_match.hpp"

#include "number/common_denominator.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <numeric>
#include <optional>

namespace mdm {
namespace {

using Integers = std::vector<Integer>;

/// The integers from lo to hi; none if lo > hi.
struct IntegerRange {
  Integer lo, hi;
};

class Apportionment {
public:
  Apportionment(const Gradation &g, const std::vector<AskedTolerance> &asked)
      : exact_(shares(g)), tolerance_(tolerance_of(g, asked, std::nullopt, 1)) {}

  /// M_j, with sum S.
  const Integers &exact() const { return exact_.numerators; }
  const Integer &exact_particles() const { return exact_.denominator; }

  /// Quantities with sum n within the tolerance, if there are any.
  std::optional<Integers> of(const Integer &n) const { return tolerance_.total ? rounded(n) : in_bounds(n); }

private:
  /// By largest remainders; of equal ones the finest class is first.
  std::optional<Integers> rounded(const Integer &n) const {
    const Integer &s = exact_.denominator;
    Integers quantities, remainders;
    Integer left = n;
    for (const Integer &m : exact()) {
      quantities.push_back(floor_div(Integer(m * n), s));
      remainders.push_back(m * n - quantities.back() * s);
      left -= quantities.back();
    }
    std::vector<std::size_t> order(remainders.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t i, std::size_t j) { return remainders[i] > remainders[j]; });
    const std::size_t raised = static_cast<std::size_t>(left);
    Integer below = 0; // what the classes that are not raised lack is half of all deviations
    for (std::size_t i = 0; i < order.size(); ++i)
      if (i < raised)
        ++quantities[order[i]];
      else
        below += remainders[order[i]];
    if (Rational(2 * below) > *tolerance_.total * Rational(Integer(n * s)))
      return std::nullopt;
    return quantities;
  }

  static IntegerRange within(const ShareBounds &bounds, const Integer &n) {
    return {ceil_div(Integer(numerator(bounds.lo) * n), denominator(bounds.lo)),
            floor_div(Integer(numerator(bounds.hi) * n), denominator(bounds.hi))};
  }
  IntegerRange retained(std::size_t j, const Integer &n) const {
    return tolerance_.retained.empty() ? IntegerRange{0, n} : within(tolerance_.retained[j], n);
  }
  IntegerRange passing(std::size_t j, const Integer &n) const {
    if (j + 1 == exact().size())
      return {n, n};
    return tolerance_.passing.empty() ? IntegerRange{0, n} : within(tolerance_.passing[j], n);
  }

  std::optional<Integers> in_bounds(const Integer &n) const {
    std::vector<IntegerRange> reached = {{0, 0}};
    for (std::size_t j = 0; j < exact().size(); ++j) {
      const IntegerRange one = retained(j, n), all = passing(j, n);
      IntegerRange next = {std::max<Integer>(reached.back().lo + one.lo, all.lo),
                           std::min<Integer>(reached.back().hi + one.hi, all.hi)};
      if (one.lo > one.hi || next.lo > next.hi)
        return std::nullopt;
      reached.push_back(std::move(next));
    }
    // Backwards, each sum as near to its exact place as it can be.
    Integers quantities(exact().size());
    Integer sum = n, exact_sum = exact_.denominator;
    for (std::size_t j = exact().size(); j-- > 0;) {
      exact_sum -= exact()[j];
      const IntegerRange one = retained(j, n);
      const Integer lo = std::max<Integer>(reached[j].lo, sum - one.hi);
      const Integer hi = std::min<Integer>(reached[j].hi, sum - one.lo);
      const Integer nearest =
          floor_div(Integer(2 * exact_sum * n + exact_.denominator), 2 * exact_.denominator);
      const Integer before = std::min<Integer>(std::max<Integer>(nearest, lo), hi);
      quantities[j] = sum - before;
      sum = before;
    }
    return quantities;
  }

  CommonDenominator exact_;
  Tolerance tolerance_;
};

void check_asked(const std::vector<AskedTolerance> &asked) {
  using Kind = AskedTolerance::Kind;
  bool has_total = false;
  for (const AskedTolerance &a : asked) {
    if (a.kind != Kind::retained && a.kind != Kind::passing && a.kind != Kind::total)
      throw InputError(option("tolerance") + ": " + in_quotes(to_string(a)) +
                       " is not of shares by number: use retained:1%, passing:1% or total:1%");
    has_total |= a.kind == Kind::total;
  }
  if (has_total && asked.size() > 1)
    throw InputError(option("tolerance") +
                     ": of shares by number a total stands alone: leave the other tolerances out");
}

} // namespace

NumberMatch number_match(const Gradation &g, const std::vector<AskedTolerance> &asked,
                         std::uint64_t max_steps) {
  check_asked(asked);
  const Apportionment shares(g, asked);
  const Integer &exact = shares.exact_particles();
  NumberMatch match{shares.exact(), exact, exact};
  if (asked.empty())
    return match;
  const Integer most = std::min<Integer>(exact, max_steps / g.classes());
  for (Integer n = 1; n <= most; ++n)
    if (std::optional<Integers> quantities = shares.of(n))
      return {std::move(*quantities), n, n};
  match.lower_bound = std::min<Integer>(exact, most + 1);
  return match;
}

} // namespace mdm
