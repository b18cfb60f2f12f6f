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

/// result = a b, in the memory that it has.
void set_product(Integer &result, const Integer &a, const Integer &b) {
  boost::multiprecision::multiply(result, a, b);
}

/// result = a / b, rounded down, for b > 0.
void set_quotient(Integer &result, const Integer &a, const Integer &b) {
  mpz_fdiv_q(result.backend().data(), a.backend().data(), b.backend().data());
}

/// The counts and shares of one class after another in a window. Shares are integers in one unit for all
/// classes. Numbers keep their memory from class to class: most of the time would go into its allocation.
class ClassPoints {
public:
  explicit ClassPoints(const WindowEnds &ends)
      : unit_(ends.s * ends.S), of_above_(ends.S_denominator * ends.s),
        of_up_to_(ends.s_denominator * ends.S) {}

  /// In how many of the classes' own shares one of these is.
  const Integer &unit() const { return unit_; }

  /// A class's own shares, and the masses of one particle as such.
  struct Shares {
    const Integer &l, &h, &target, &f, &F;
  };

  /// What a share is worth, a particle, and, as a loss, a share above the target.
  struct Worth {
    Integer share, count, excess;
  };

  /// False if the class has no counts.
  bool set(const Shares &shares, const CountBound &bound) {
    set_product(l_, shares.l, unit_);
    set_product(h_, shares.h, unit_);
    set_product(target_, shares.target, unit_);
    set_product(above_, shares.f, of_above_);
    set_product(up_to_, shares.F, of_up_to_);
    least_ = bound.least;
    if (l_ > 0)
      least_ = std::max(least_, up_to_ > 0 ? Integer(floor_div(l_, up_to_) + 1) : Integer(1));
    has_limit_ = bound.most.has_value();
    if (has_limit_)
      limit_ = *bound.most;
    if (h_ <= 0) {
      limit_ = 0;
      has_limit_ = true;
    }
    return fits(least_);
  }

  bool has_most() const { return has_limit_ || above_ > 0; }

  /// The greatest worth of all points. \pre set() had counts, and a particle is worth nothing without a most
  void find_greatest(const Worth &of) {
    has_greatest_ = false;
    if (of.excess == 0 && of.share > 0 && of.count < 0 && up_to_ > 0)
      return find_at_kink(of);
    include(least_, of);
    include_inside(1, of);
    if (has_most()) {
      find_most();
      include(most_, of);
    }
    if (of.excess > 0 || of.share >= 0)
      include_beside(h_, up_to_, of);
    if (of.excess > 0 || of.share <= 0)
      include_beside(l_, above_, of);
    if (of.excess > 0) {
      include_beside(target_, up_to_, of);
      include_beside(target_, above_, of);
    }
  }
  const Integer &greatest() const { return greatest_; }
  /// Whether a point has it, rather than an open end alone.
  bool is_reached() const { return is_reached_; }

private:
  /// Whether the class can have so many particles.
  bool fits(const Integer &q) {
    if (has_limit_ && q > limit_)
      return false;
    set_product(value_, q, above_);
    return q == 0 || value_ < h_;
  }

  /// A division, where comparing a product does not do. \pre has_most()
  void find_most() {
    most_ = limit_;
    if (h_ <= 0 || above_ <= 0)
      return;
    value_ = h_;
    set_quotient(kink_, --value_, above_);
    if (!has_limit_ || kink_ < most_)
      most_ = kink_;
  }

  /// Where a share is worth something and a particle costs something, the greatest value is a concave
  /// function of q. Up to its kink a particle adds `up_to_`, which is an open end; the next one has the
  /// greatest share.
  void find_at_kink(const Worth &of) {
    set_product(of_one_, of.share, up_to_);
    of_one_ += of.count;
    set_quotient(kink_, h_, up_to_);
    if (of_one_ <= 0 || kink_ < least_)
      return include(least_, of);
    set_product(greatest_, of_one_, kink_);
    is_reached_ = kink_ == 0;
    if (!fits(++kink_)) {
      find_most();
      return include(most_, of);
    }
    set_product(value_, of.share, h_);
    set_product(of_count_, of.count, kink_);
    value_ += of_count_;
    is_reached_ = is_reached_ || value_ >= greatest_;
    if (value_ > greatest_)
      greatest_.swap(value_);
  }

  void include_inside(const Integer &q, const Worth &of) {
    if (q >= least_ && fits(q))
      include(q, of);
  }

  /// Beside which the greatest value, a concave function of q, has its kinks: without the target, those of
  /// the greatest shares where a share is worth something, of the least where it costs something.
  void include_beside(const Integer &share, const Integer &of_one, const Worth &of) {
    if (of_one <= 0)
      return;
    set_quotient(kink_, share, of_one);
    include_inside(kink_, of);
    include_inside(++kink_, of);
  }

  void include(const Integer &q, const Worth &of) {
    set_product(of_count_, of.count, q);
    if (q == 0)
      return see(q, true, of);
    set_product(of_lower_, q, above_);
    set_product(of_upper_, q, up_to_);
    const Integer &low = of_lower_ < l_ ? l_ : of_lower_;
    const Integer &high = up_to_ > 0 && of_upper_ < h_ ? of_upper_ : h_;
    if (of.share <= of.excess || low == high) // else the other end is greater
      see(low, of_lower_ < l_, of);
    if (of.share >= 0 || low == high)
      see(high, up_to_ == 0 || of_upper_ > h_, of);
    if (low < target_ && target_ < high)
      see(target_, true, of);
    const bool is_flat =
        (of.share == 0 && (of.excess == 0 || high <= target_)) || (of.share == of.excess && low >= target_);
    if (low < high && is_flat)
      see(low, true, of);
  }

  void see(const Integer &y, bool is_reached, const Worth &of) {
    set_product(value_, of.share, y);
    value_ += of_count_;
    if (of.excess > 0 && y > target_)
      value_ -= of.excess * (y - target_);
    const int order = has_greatest_ ? value_.compare(greatest_) : 1;
    if (order > 0)
      greatest_.swap(value_);
    is_reached_ = order > 0 ? is_reached : is_reached_ || (order == 0 && is_reached);
    has_greatest_ = true;
  }

  const Integer unit_, of_above_, of_up_to_;
  Integer l_, h_, target_;
  Integer above_, up_to_; ///< one particle's share is above `above_` and, where that is not 0, up to `up_to_`
  Integer least_, limit_, most_; ///< counts; `limit_` where counts are bounded, `most_` where it is found
  bool has_limit_ = false;
  Integer kink_, of_one_, of_count_, of_lower_, of_upper_, value_;
  Integer greatest_;
  bool has_greatest_ = false, is_reached_ = false;
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
    if (step == 0)
      continue;
    const ShareBounds bounds = tolerance.passing.empty() ? ShareBounds{} : tolerance.passing[j];
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
  ClassPoints points{WindowEnds(window)};
  const Integer of_count = prices.at_least - prices.particles;
  const Integer value_unit = unit_ * points.unit() * unit_;
  ClassPoints::Worth worth{0, of_count * value_unit, prices.excess * unit_};
  Integer greatest = 0;
  bool is_reached = true, is_bounded = true;
  for (std::size_t j = 0; j < l_.size(); ++j) {
    if (!points.set({l_[j], h_[j], target_[j], f_[j], F_[j]}, bounds[j]))
      return {true, 0};
    is_bounded = is_bounded && (of_count <= 0 || points.has_most());
    if (!is_bounded)
      continue;
    set_product(worth.share, prices.shares[j], unit_);
    if (prices.weight > 0)
      worth.share += prices.weight * per_mass_[j];
    points.find_greatest(worth);
    greatest += points.greatest();
    is_reached = is_reached && points.is_reached();
  }
  if (!is_bounded)
    return {};
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
