// Exact bounds from multipliers that doubles have found (Theorem 14, "Or doubles propose multiples"). What
// comes in are conditions with doubles beside them; what goes out is a leaf in integers and the number of
// particles that it proves.
//
// Multipliers of conditions on shares and on sums of counts are rounded to integers over a power of two and
// kept. What is then left of each mass is cancelled exactly by one of the conditions q f < t <= q F, of
// each excess by its sign, and of each count by N and by the bounds on it. What remains says N >= R / n. So
// it is true whatever the doubles were; good doubles make it a good bound.

#include "match/certain_bound.hpp"

#include "match/leaf_sum.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

using Condition = TolerantCondition;

bool is_of_masses(Condition condition) {
  return condition != Condition::least_sum && condition != Condition::most_sum &&
         condition != Condition::at_least && condition != Condition::fewer;
}

/// The power of two that makes integers with enough digits of all multipliers but those that are nothing
/// beside the greatest.
int scale_of(const std::vector<Steering> &steering) {
  constexpr int bits = 36, most_apart = 256;
  int least = 0, greatest = 0;
  for (auto s = steering.begin(); s != steering.end(); ++s) {
    const int exponent = std::ilogb(s->multiplier);
    least = s == steering.begin() ? exponent : std::min(least, exponent);
    greatest = s == steering.begin() ? exponent : std::max(greatest, exponent);
  }
  return bits - std::max(least, greatest - most_apart);
}

} // namespace

/// Multiples of conditions that are added up, in terms of the variables, in units of a share.
struct BoundMaker::Sum {
  TreeNode leaf;
  std::vector<Integer> counts, excesses; ///< coefficients
  std::vector<Integer> masses;           ///< of each mass, less that of the one before
  Integer all_masses = 0;                ///< coefficient of M besides
  Integer all_counts = 0;                ///< coefficient of the number of particles besides
  Integer all_excesses = 0;
  Integer particles = 0; ///< how often it is to be bounded
  Integer right = 0;
  bool strict = false;

  std::vector<std::pair<Steering, Integer>> of_masses;

  explicit Sum(std::size_t k) : counts(k, 0), excesses(k, 0), masses(k + 1, 0) {}

  void take(Condition condition, std::size_t i, std::size_t j, Integer m) {
    if (m != 0)
      leaf.leaf.push_back({condition, j, std::move(m), i});
  }
  CertainBound found() && {
    CertainBound result;
    if (particles > 0)
      result.particles = strict ? Integer(floor_div(right, particles) + 1) : ceil_div(right, particles);
    else if (!(right > 0 || (right == 0 && strict)))
      result.particles = 0;
    if (!result.particles || *result.particles > 0) {
      reduce_multipliers(leaf);
      result.leaf = std::move(leaf);
    }
    return result;
  }
  void add_masses(std::size_t from, std::size_t to, const Integer &m) {
    masses[from] += m;
    masses[to + 1] -= m;
  }
};

BoundMaker::BoundMaker(const TolerantProblem &problem) : problem_(problem), k_(problem.classes()) {
  const Tolerance &tolerance = problem.tolerance();
  std::vector<Rational> all;
  for (std::size_t j = 0; j < k_; ++j) {
    all.push_back(problem.target()[j]);
    all.push_back(problem.per_mass(j));
  }
  for (const std::vector<ShareBounds> *bounds : {&tolerance.retained, &tolerance.passing})
    for (const ShareBounds &b : *bounds) {
      all.push_back(b.lo);
      all.push_back(b.hi);
    }
  all.push_back(tolerance.total.value_or(Rational(0)) / 2);
  all.push_back(problem.weight().value_or(Rational(0)));
  const CommonDenominator common(all);
  unit_ = common.denominator;
  auto next = common.numerators.begin();
  for (std::size_t j = 0; j < k_; ++j) {
    target_.push_back(*next++);
    per_mass_.push_back(*next++);
  }
  for (std::size_t j = 0; j < tolerance.retained.size(); ++j, next += 2)
    retained_.emplace_back(*next, *std::next(next));
  for (std::size_t j = 0; j < tolerance.passing.size(); ++j, next += 2)
    passing_.emplace_back(*next, *std::next(next));
  half_total_ = *next++;
  weight_ = *next;
}

/// m times a condition, which is above 0 or at least 0 for masses, in units of a share.
void BoundMaker::add(Sum &sum, const Steering &of, const Integer &m) const {
  const auto add_part = [&](std::size_t from, std::size_t to, const Integer &times, const Integer &share) {
    sum.add_masses(from, to, Integer(times * unit_));
    sum.all_masses -= times * share;
  };
  switch (of.condition) {
  case Condition::retained_lo:
    return add_part(of.j, of.j, m, retained_[of.j].first);
  case Condition::retained_hi:
    return add_part(of.j, of.j, Integer(-m), retained_[of.j].second);
  case Condition::passing_lo:
    return add_part(0, of.j, m, passing_[of.j].first);
  case Condition::passing_hi:
    return add_part(0, of.j, Integer(-m), passing_[of.j].second);
  case Condition::excess:
    sum.excesses[of.j] += m;
    return add_part(of.j, of.j, Integer(-m), target_[of.j]);
  case Condition::excess_total:
    sum.all_excesses += m;
    sum.all_masses += m * half_total_;
    return;
  case Condition::some_mass:
    sum.all_masses += m * unit_;
    sum.strict = true;
    return;
  case Condition::weight:
    for (std::size_t b = 0; b < k_; ++b)
      sum.add_masses(b, b, Integer(m * per_mass_[b]));
    sum.right += m * weight_;
    return;
  default:
    return;
  }
}

/// Adds up what is not to be cancelled.
BoundMaker::Sum BoundMaker::steered(const CountBounds &bounds, const std::vector<Steering> &steering) const {
  Sum sum(k_);
  const int scale = scale_of(steering);
  const auto whole = [scale](double multiplier) {
    return Integer(std::round(std::ldexp(multiplier, scale)));
  };
  Integer most_excess = 0;
  for (const Steering &s : steering)
    if (s.condition == Condition::excess_total)
      most_excess = whole(s.multiplier);
  for (const Steering &s : steering) {
    Integer m = whole(s.multiplier);
    if (s.condition == Condition::excess)
      m = std::min(m, most_excess);
    if (m == 0)
      continue;
    if (is_of_masses(s.condition)) {
      add(sum, s, m);
      sum.of_masses.emplace_back(s, m);
    } else if (s.condition == Condition::fewer) {
      sum.particles += m * unit_;
    } else {
      add_counts(sum, bounds, s, Integer(m * unit_));
    }
  }
  return sum;
}

/// m times a condition on counts.
void BoundMaker::add_counts(Sum &sum, const CountBounds &bounds, const Steering &of, const Integer &m) const {
  if (of.condition == Condition::at_least) {
    sum.all_counts += m;
    sum.right += m * problem_.at_least();
    return sum.take(of.condition, 0, 0, m);
  }
  const auto known = bounds.sums.find({of.i, of.j});
  const bool is_least = of.condition == Condition::least_sum;
  if (known == bounds.sums.end() || (!is_least && !known->second.most))
    return; // what follows from the classes' bounds and the number of particles
  const CountBound &bound = known->second;
  for (std::size_t b = of.i; b <= of.j; ++b)
    sum.counts[b] += is_least ? m : Integer(-m);
  sum.right += is_least ? Integer(m * bound.least) : Integer(-m * *bound.most);
  sum.take(of.condition, of.i, of.j, m);
}

/// Counts of coarse classes are small differences of large numbers. What they have too much is taken away
/// from all masses, by a little more of the condition that has most of them.
void BoundMaker::correct(Sum &sum, const CountBounds &bounds) const {
  Integer less = 0, mass = sum.all_masses;
  for (std::size_t b = 0; b < k_; ++b) {
    mass += sum.masses[b];
    const Integer surplus = sum.counts[b] + sum.all_counts + mass * problem_.F(b) - sum.particles;
    if (mass > 0 && surplus > 0 && !bounds.classes[b].most)
      less = std::max(less, ceil_div(surplus, problem_.F(b)));
  }
  const auto part = [this](const std::pair<Steering, Integer> &row) {
    const Steering &s = row.first;
    return s.condition == Condition::retained_lo  ? Integer(row.second * retained_[s.j].first)
           : s.condition == Condition::passing_lo ? Integer(row.second * passing_[s.j].first)
                                                  : Integer(0);
  };
  std::pair<Steering, Integer> *most = nullptr;
  for (std::pair<Steering, Integer> &row : sum.of_masses)
    if (part(row) > 0 && (!most || part(row) > part(*most)))
      most = &row;
  constexpr int noise = 1000000; // more would change what the condition says of its own classes
  if (!most || less * noise > part(*most))
    return;
  const Integer more = ceil_div(Integer(less * most->second), part(*most));
  add(sum, most->first, more);
  most->second += more;
}

CertainBound BoundMaker::bound(const CountBounds &bounds, const std::vector<Steering> &steering) const {
  Sum sum = steered(bounds, steering);
  correct(sum, bounds);
  for (const auto &[s, m] : sum.of_masses)
    sum.take(s.condition, s.j, s.j, Integer(m * unit_));
  for (std::size_t j = 0; j < k_; ++j)
    sum.take(Condition::excess_sign, j, j, Integer((sum.all_excesses - sum.excesses[j]) * unit_));
  Integer mass = sum.all_masses;
  for (std::size_t b = 0; b < k_; ++b) {
    mass += sum.masses[b];
    sum.counts[b] += sum.all_counts + mass * (mass > 0 ? problem_.F(b) : problem_.f(b));
    sum.take(mass > 0 ? Condition::up_to_upper : Condition::above_lower, b, b, Integer(abs(mass)));
    sum.strict = sum.strict || (mass < 0 && bounds.classes[b].least >= 1);
    if (!bounds.classes[b].most)
      sum.particles = std::max(sum.particles, sum.counts[b]);
  }
  for (std::size_t b = 0; b < k_; ++b) {
    const Integer missing = sum.particles - sum.counts[b];
    if (missing == 0)
      continue;
    const bool is_least = missing > 0;
    const CountBound &bound = bounds.classes[b];
    sum.right += missing * (is_least ? bound.least : *bound.most);
    sum.take(is_least ? Condition::least_count : Condition::most_count, b, b, Integer(abs(missing)));
  }
  sum.take(Condition::fewer, 0, 0, sum.particles);
  return std::move(sum).found();
}

} // namespace mdm
