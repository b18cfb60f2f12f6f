// Leaves of windows of the mass, exactly (Theorem 20; certificate-format.md, section 6). What comes in is a
// window s < M <= S, bounds on counts, and prices for shares, excess, weight and particles; what goes out
// is how many particles the prices prove.
//
// The classes are independent once prices are fixed: for each, the greatest value V_j of its part over its
// points (q, y) is taken at one of a few counts (Theorem 20 (c)), and sum V_j < d, or = d where some class
// cannot have its V_j, refutes. The number of particles enters d alone, so the greatest number that is
// refuted is a quotient, rounded.
//
// shortened() looks for the fewest decimal digits of the prices that still prove the same number:
// certificates are shorter, and a checker works less.

#include "match/mass_window.hpp"

#include "match/leaf_sum.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// Bounds on single shares that follow from all of a tolerance (certificate-format.md, section 6).
std::vector<ShareBounds> closed_shares(const TolerantProblem &problem) {
  const std::size_t k = problem.classes();
  const Tolerance &tolerance = problem.tolerance();
  const Rational half = tolerance.total.value_or(Rational(2)) / 2;
  const auto near_target = [&half](ShareBounds bounds, const Rational &target) {
    return ShareBounds{std::max(bounds.lo, Rational(target - half)),
                       std::min(bounds.hi, Rational(target + half))};
  };
  std::vector<ShareBounds> retained, passing{{0, 0}};
  Rational target = 0;
  for (std::size_t j = 0; j < k; ++j) {
    const ShareBounds whole;
    target += problem.target()[j];
    retained.push_back(
        near_target(tolerance.retained.empty() ? whole : tolerance.retained[j], problem.target()[j]));
    passing.push_back(near_target(tolerance.passing.empty() ? whole : tolerance.passing[j], target));
  }
  passing.back() = {1, 1};
  for (std::size_t j = 1; j <= k; ++j) {
    passing[j].lo = std::max(passing[j].lo, Rational(passing[j - 1].lo + retained[j - 1].lo));
    passing[j].hi = std::min(passing[j].hi, Rational(passing[j - 1].hi + retained[j - 1].hi));
  }
  for (std::size_t j = k - 1; j > 0; --j) {
    passing[j].lo = std::max(passing[j].lo, Rational(passing[j + 1].lo - retained[j].hi));
    passing[j].hi = std::min(passing[j].hi, Rational(passing[j + 1].hi - retained[j].lo));
  }
  for (std::size_t j = 0; j < k; ++j) {
    retained[j].lo = std::max(retained[j].lo, Rational(passing[j + 1].lo - passing[j].hi));
    retained[j].hi = std::min(retained[j].hi, Rational(passing[j + 1].hi - passing[j].lo));
  }
  return retained;
}

/// A window's ends as fractions whose numerators are 1 where the end is 0 or infinite.
struct WindowEnds {
  bool has_above, has_up_to;
  Integer s, s_denominator, S, S_denominator;

  explicit WindowEnds(const MassWindow &window)
      : has_above(window.above > 0), has_up_to(window.up_to.has_value()), s(1), s_denominator(0), S(1),
        S_denominator(0) {
    if (has_above) {
      s = numerator(window.above);
      s_denominator = denominator(window.above);
    }
    if (has_up_to) {
      S = numerator(*window.up_to);
      S_denominator = denominator(*window.up_to);
    }
  }
};

/// The counts and shares of a class in a window. Shares are integers in one unit for all classes.
class ClassPoints {
public:
  struct Shares {
    Integer l, h, target;
    Integer above, up_to; ///< one particle's share is above `above` and, where that is not 0, up to `up_to`
  };

  ClassPoints(Shares shares, const CountBound &bound)
      : of_(std::move(shares)), least_(bound.least), most_(bound.most) {
    if (of_.l > 0)
      least_ = std::max(least_, of_.up_to > 0 ? Integer(floor_div(of_.l, of_.up_to) + 1) : Integer(1));
    if (of_.h <= 0)
      most_ = std::min(Integer(0), most_.value_or(Integer(0)));
    else if (of_.above > 0)
      limit(Integer(ceil_div(of_.h, of_.above) - 1));
  }

  bool is_empty() const { return most_ && least_ > *most_; }
  bool has_most() const { return most_.has_value(); }

  struct Greatest {
    std::optional<Integer> value;
    bool is_reached = false;
  };

  /// The greatest c y + e q - mu (y - g)^+ of all points, and whether one has it, rather than an open end
  /// alone.
  Greatest greatest(const Integer &c, const Integer &e, const Integer &mu) const {
    Greatest best;
    for (const Integer &q : candidates(c, mu > 0))
      include(best, q, c, e, mu);
    return best;
  }

private:
  void limit(const Integer &most) { most_ = most_ ? std::min(*most_, most) : most; }

  /// Beside which the greatest value, a concave function of q, has its kinks: without the target, those of
  /// the greatest shares where a share is worth something, of the least where it costs something.
  std::vector<Integer> candidates(const Integer &c, bool with_target) const {
    std::vector<Integer> all{least_, 1};
    if (most_)
      all.push_back(*most_);
    const auto beside = [&](const Integer &share, const Integer &of_one) {
      if (of_one <= 0)
        return;
      const Integer q = floor_div(share, of_one);
      all.push_back(q);
      all.push_back(q + 1);
    };
    if (with_target || c >= 0)
      beside(of_.h, of_.up_to);
    if (with_target || c <= 0)
      beside(of_.l, of_.above);
    if (with_target) {
      beside(of_.target, of_.up_to);
      beside(of_.target, of_.above);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    const auto is_outside = [&](const Integer &q) { return q < least_ || (most_ && q > *most_); };
    all.erase(std::remove_if(all.begin(), all.end(), is_outside), all.end());
    return all;
  }

  void include(Greatest &best, const Integer &q, const Integer &c, const Integer &e,
               const Integer &mu) const {
    const auto see = [&](const Integer &y, bool is_reached) {
      Integer value = c * y + e * q;
      if (mu > 0 && y > of_.target)
        value -= mu * (y - of_.target);
      if (!best.value || value > *best.value)
        best = {std::move(value), is_reached};
      else if (value == *best.value)
        best.is_reached = best.is_reached || is_reached;
    };
    if (q == 0)
      return see(0, true);
    const Integer of_lower = q * of_.above, of_upper = q * of_.up_to;
    const Integer low = std::max(of_.l, of_lower), high = of_.up_to > 0 ? std::min(of_.h, of_upper) : of_.h;
    if (c <= mu || low == high) // else the other end is greater
      see(low, of_lower < of_.l);
    if (c >= 0 || low == high)
      see(high, of_.up_to == 0 || of_upper > of_.h);
    if (low < of_.target && of_.target < high)
      see(of_.target, true);
    const bool is_flat = (c == 0 && (mu == 0 || high <= of_.target)) || (c == mu && low >= of_.target);
    if (low < high && is_flat)
      see(low, true);
  }

  Shares of_;
  Integer least_;
  std::optional<Integer> most_;
};

} // namespace

void MassWindow::narrow(const Rational &mass, bool is_first) {
  if (!is_first)
    above = std::max(above, mass);
  else if (!up_to || mass < *up_to)
    up_to = mass;
}

MassWindows::MassWindows(const TolerantProblem &problem)
    : problem_(problem), shares_(closed_shares(problem)) {
  const std::size_t k = problem.classes();
  std::vector<Rational> all;
  for (std::size_t j = 0; j < k; ++j) {
    all.push_back(shares_[j].lo);
    all.push_back(shares_[j].hi);
    all.push_back(problem.tolerance().total ? problem.target()[j] : Rational(0));
    all.push_back(problem.weight() ? problem.per_mass(j) : Rational(0));
  }
  const CommonDenominator common(all);
  unit_ = common.denominator;
  for (std::size_t j = 0; j < k; ++j) {
    l_.push_back(common.numerators[4 * j]);
    h_.push_back(common.numerators[4 * j + 1]);
    target_.push_back(common.numerators[4 * j + 2]);
    per_mass_.push_back(common.numerators[4 * j + 3]);
    f_.emplace_back(problem.f(j) * unit_);
    F_.emplace_back(problem.F(j) * unit_);
  }
}

/// Of all conditions but `fewer`.
Rational MassWindows::right_side(const MassWindow &window, const WindowPrices &prices) const {
  const std::size_t k = problem_.classes();
  const Tolerance &tolerance = problem_.tolerance();
  std::vector<Rational> parts{Rational(prices.shares.back()),
                              Rational(prices.at_least * problem_.at_least())};
  for (std::size_t j = 0; j + 1 < k; ++j) {
    const Integer step = prices.shares[j] - prices.shares[j + 1];
    const ShareBounds bounds = tolerance.passing.empty() ? ShareBounds{} : tolerance.passing[j];
    if (step != 0)
      parts.push_back(step * (step > 0 ? bounds.lo : bounds.hi));
  }
  if (prices.excess > 0)
    parts.push_back(-(prices.excess * *tolerance.total / 2));
  if (prices.weight > 0 && window.up_to)
    parts.push_back(prices.weight * *problem_.weight() / *window.up_to);
  return sum(parts);
}

WindowVerdict MassWindows::verdict(const MassWindow &window, const CountBounds &bounds,
                                   const WindowPrices &prices) const {
  const WindowEnds ends(window);
  const Integer ends_unit = ends.s * ends.S, share_unit = unit_ * ends_unit;
  const Integer of_above = ends.S_denominator * ends.s, of_up_to = ends.s_denominator * ends.S;
  std::vector<ClassPoints> classes;
  for (std::size_t j = 0; j < l_.size(); ++j) {
    classes.emplace_back(ClassPoints::Shares{l_[j] * ends_unit, h_[j] * ends_unit, target_[j] * ends_unit,
                                             f_[j] * of_above, F_[j] * of_up_to},
                         bounds.classes[j]);
    if (classes.back().is_empty())
      return {true, 0};
  }
  const Integer of_count = prices.at_least - prices.particles;
  const Integer value_unit = share_unit * unit_;
  Integer greatest = 0;
  bool is_reached = true;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    if (of_count > 0 && !classes[j].has_most())
      return {};
    const ClassPoints::Greatest of =
        classes[j].greatest(Integer(prices.shares[j] * unit_ + prices.weight * per_mass_[j]),
                            Integer(of_count * value_unit), Integer(prices.excess * unit_));
    greatest += *of.value;
    is_reached = is_reached && of.is_reached;
  }
  const Rational missing = right_side(window, prices) - ratio(greatest, value_unit);
  if (prices.particles == 0)
    return {missing > 0 || (missing == 0 && !is_reached), 0};
  const Rational particles = missing / Rational(prices.particles);
  return {false, is_reached ? ceil(particles) : Integer(floor(particles) + 1)};
}

TreeNode MassWindows::leaf(const WindowPrices &prices) const {
  TreeNode node;
  node.is_window = true;
  const auto add = [&node](TolerantCondition condition, std::size_t j, const Integer &m) {
    if (m != 0)
      node.leaf.push_back({condition, j, m, j});
  };
  const std::size_t k = prices.shares.size();
  add(TolerantCondition::fewer, 0, prices.particles);
  add(TolerantCondition::at_least, 0, prices.at_least);
  const Integer &whole = prices.shares.back();
  add(whole > 0 ? TolerantCondition::whole_lo : TolerantCondition::whole_hi, 0, Integer(abs(whole)));
  for (std::size_t j = 0; j + 1 < k; ++j) {
    const Integer step = prices.shares[j] - prices.shares[j + 1];
    add(step > 0 ? TolerantCondition::passing_lo : TolerantCondition::passing_hi, j, Integer(abs(step)));
  }
  add(TolerantCondition::excess_total, 0, prices.excess);
  add(TolerantCondition::weight, 0, prices.weight);
  if (!node.leaf.empty())
    reduce_multipliers(node);
  return node;
}

WindowPrices MassWindows::prices_of(const TreeNode &leaf) const {
  WindowPrices prices{std::vector<Integer>(problem_.classes())};
  for (const Multiple &m : leaf.leaf)
    switch (m.condition) {
    case TolerantCondition::fewer:
      prices.particles = m.multiplier;
      break;
    case TolerantCondition::at_least:
      prices.at_least = m.multiplier;
      break;
    case TolerantCondition::excess_total:
      prices.excess = m.multiplier;
      break;
    case TolerantCondition::weight:
      prices.weight = m.multiplier;
      break;
    case TolerantCondition::whole_lo:
      prices.shares.back() += m.multiplier;
      break;
    case TolerantCondition::whole_hi:
      prices.shares.back() -= m.multiplier;
      break;
    case TolerantCondition::passing_lo:
      prices.shares[m.j] += m.multiplier;
      break;
    default: // passing_hi
      prices.shares[m.j] -= m.multiplier;
    }
  for (std::size_t j = prices.shares.size() - 1; j-- > 0;)
    prices.shares[j] += prices.shares[j + 1];
  return prices;
}

WindowPrices MassWindows::shortened(const MassWindow &window, const CountBounds &bounds,
                                    const WindowPrices &prices, const Integer &particles) const {
  const bool refutes_all = prices.particles == 0;
  Integer greatest = std::max({prices.particles, prices.at_least, prices.excess, prices.weight});
  for (const Integer &share : prices.shares)
    greatest = refutes_all ? std::max(greatest, Integer(abs(share))) : greatest;
  const Integer &of = refutes_all ? greatest : prices.particles;
  WindowPrices shorter{std::vector<Integer>(prices.shares.size())};
  if (of == 0 || verdict(window, bounds, shorter).is_refuted)
    return shorter;
  Integer scale = 1;
  for (; scale < of; scale *= 10) {
    const auto scaled = [&](const Integer &n) {
      return Integer(floor_div(Integer(2 * n * scale + of), Integer(2 * of)));
    };
    std::transform(prices.shares.begin(), prices.shares.end(), shorter.shares.begin(), scaled);
    shorter.excess = scaled(prices.excess);
    shorter.weight = scaled(prices.weight);
    shorter.particles = scaled(prices.particles);
    shorter.at_least = scaled(prices.at_least);
    const WindowVerdict found = verdict(window, bounds, shorter);
    if (found.is_refuted || (!refutes_all && shorter.particles > 0 && found.particles >= particles))
      return shorter;
  }
  return prices;
}

} // namespace mdm
