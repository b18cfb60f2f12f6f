#pragma once
/// \file
/// Problems within a tolerance for the solver and for enumeration alike, and a reader of trees that shares
/// nothing with the one that writes them.

#include "catch.hpp"
#include "match/problem.hpp"
#include "match/tolerant_match.hpp"
#include "plain_gradation.hpp"
#include "tolerant_brute_force.hpp"

#include <mdm/match/solve.hpp>

namespace tolerant_twins {

using namespace mdm;

/// The same problem for the solver and for enumeration.
struct Twins {
  TolerantProblem problem;
  tolerant_brute::Problem brute;

  Twins(const Gradation &g, const MassLaw &law, const Tolerance &tolerance, const TolerantDemands &demands)
      : problem(g, law, tolerance, demands), brute{{}, shares(g), tolerance, demands} {
    for (std::size_t j = 0; j < g.classes(); ++j)
      brute.classes.push_back({g.factor(j) * power(g.lower(j), law.a), g.factor(j) * power(g.upper(j), law.a),
                               g.factor(j), g.mass(j) > 0});
  }
};

inline Tolerance tolerance_of(const Gradation &g, AskedTolerance::Kind kind, const Rational &percent) {
  return mdm::tolerance_of(g, {{kind, percent}}, std::nullopt, 1);
}

/// Small classes that touch, some of them empty, widths from narrow to wide, sometimes from 0 on.
inline Gradation random_gradation(std::mt19937_64 &random, std::size_t most_classes) {
  const std::size_t n = 2 + random() % most_classes;
  std::set<int> sizes;
  const int finest = random() % 2 == 0 ? 0 : static_cast<int>(1 + random() % 6);
  while (sizes.size() < n)
    sizes.insert(finest + static_cast<int>(random() % 7));
  Gradation::Data data;
  for (const int x : sizes)
    data.sizes.emplace_back(x);
  for (std::size_t j = 0; j + 1 < n; ++j)
    data.masses.emplace_back(random() % 4 == 0 ? 0 : static_cast<int>(1 + random() % 8));
  if (std::all_of(data.masses.begin(), data.masses.end(), [](const Rational &m) { return m == 0; }))
    data.masses.front() = 1;
  data.masses.emplace_back(0);
  if (random() % 4 == 0)
    for (std::size_t j = 0; j < n; ++j)
      data.factors.push_back(ratio(static_cast<int>(1 + random() % 4), static_cast<int>(1 + random() % 3)));
  return Gradation(std::move(data));
}

inline Rational random_percent(std::mt19937_64 &random) {
  const Rational percents[] = {0, 1, 2, 5, ratio(25, 2), 10, 20, 25, 25, 30, ratio(100, 3), 50, 75, 100};
  return percents[random() % 14];
}

/// Bounds in tenths on some sieves, now and then contradictory.
inline Tolerance random_band(std::size_t classes, std::mt19937_64 &random) {
  Tolerance tolerance;
  for (std::size_t j = 0; j < classes; ++j) {
    const int a = static_cast<int>(random() % 11), b = static_cast<int>(random() % 11);
    if (random() % 4 == 0)
      tolerance.passing.push_back({0, 1});
    else if (random() % 10 == 0)
      tolerance.passing.push_back({ratio(a, 10), ratio(b, 10)});
    else
      tolerance.passing.push_back({ratio(std::min(a, b), 10), ratio(std::max(a, b), 10)});
  }
  if (random() % 8 != 0)
    tolerance.passing.back() = {0, 1};
  return tolerance;
}

inline Tolerance random_tolerance(const Gradation &g, std::mt19937_64 &random) {
  using Kind = AskedTolerance::Kind;
  switch (random() % 6) {
  case 0:
  case 1:
    return tolerance_of(g, Kind::retained, random_percent(random));
  case 2:
    return tolerance_of(g, Kind::passing, random_percent(random));
  case 3:
    return tolerance_of(g, Kind::total, random_percent(random));
  case 4:
    return mdm::tolerance_of(
        g, {{Kind::retained, random_percent(random)}, {Kind::total, random_percent(random)}}, std::nullopt,
        1);
  default:
    return random_band(g.classes(), random);
  }
}

inline Twins random_twins(std::mt19937_64 &random, std::size_t most_classes) {
  const Gradation g = random_gradation(random, most_classes);
  const MassLaw laws[] = {{1, 1}, {1, 1}, {2, 1}, {3, 1}};
  TolerantDemands demands;
  if (random() % 5 == 0)
    demands.min_per_class = static_cast<int>(1 + random() % 3);
  if (random() % 4 == 0)
    demands.at_least = static_cast<int>(1 + random() % 7);
  if (random() % 4 == 0 && !g.has_factors())
    demands.weight = static_cast<int>(1 + random() % 40);
  return {g, laws[random() % 4], random_tolerance(g, random), demands};
}

/// q and t satisfy every condition, by the definitions.
inline void check_match(const Twins &twins, const TolerantMatch &match) {
  const tolerant_brute::Problem &p = twins.brute;
  REQUIRE(match.q.size() == p.classes.size());
  REQUIRE(match.t.size() == p.classes.size());
  Rational all = 0, weight = 0, deviation = 0, passing = 0;
  for (std::size_t j = 0; j < match.t.size(); ++j) {
    all += match.t[j] / twins.problem.unit();
    weight += match.t[j] / twins.problem.unit() / p.classes[j].factor;
  }
  CHECK(all > 0);
  if (p.demands.weight)
    CHECK(weight >= *p.demands.weight);
  CHECK(total(match.q) >= p.demands.at_least);
  for (std::size_t j = 0; j < match.q.size(); ++j) {
    const Rational t = match.t[j] / twins.problem.unit(), share = t / all;
    CHECK(t <= p.classes[j].F * Rational(match.q[j]));
    CHECK((match.q[j] == 0 ? t == 0 : t > p.classes[j].f * Rational(match.q[j])));
    if (p.classes[j].has_mass)
      CHECK(match.q[j] >= p.demands.min_per_class);
    deviation += abs(Rational(share - p.target[j]));
    passing += share;
    if (!p.tolerance.retained.empty()) {
      CHECK(share >= p.tolerance.retained[j].lo);
      CHECK(share <= p.tolerance.retained[j].hi);
    }
    if (!p.tolerance.passing.empty()) {
      CHECK(passing >= p.tolerance.passing[j].lo);
      CHECK(passing <= p.tolerance.passing[j].hi);
    }
  }
  if (p.tolerance.total)
    CHECK(deviation <= *p.tolerance.total);
}

/// The contradiction of every leaf and the splits between them, by the definitions of the conditions: a
/// refutation of fewer than n particles, or of any number.
class TreeReader {
public:
  TreeReader(const Twins &twins, const Tree &tree, const std::optional<Integer> &n)
      : twins_(twins), tree_(tree), n_(n), k_(twins.brute.classes.size()), most_(k_) {
    for (std::size_t j = 0; j < k_; ++j)
      least_.push_back(twins.problem.least(j));
  }

  bool holds() {
    const bool all = subtree();
    return all && next_ == tree_.size();
  }

private:
  bool subtree() {
    if (next_ == tree_.size())
      return false;
    const TreeNode &node = tree_[next_++];
    if (node.is_window)
      return is_without_match(node.leaf);
    if (!node.is_split())
      return is_contradiction(node.leaf);
    if (node.mass)
      return windows(*node.mass / twins_.problem.unit());
    const std::optional<Integer> most = most_of(node.i, node.j);
    const Integer least = least_of(node.i, node.j);
    most_of(node.i, node.j) = node.v - 1;
    if (!subtree())
      return false;
    most_of(node.i, node.j) = most;
    least_of(node.i, node.j) = node.v;
    const bool second = subtree();
    least_of(node.i, node.j) = least;
    return second;
  }

  /// Both cases of a split of M.
  bool windows(const Rational &mass) {
    const Rational above = above_;
    const std::optional<Rational> up_to = up_to_;
    up_to_ = up_to ? std::min(*up_to, mass) : mass;
    if (!subtree())
      return false;
    up_to_ = up_to;
    above_ = std::max(above, mass);
    const bool second = subtree();
    above_ = above;
    return second;
  }

  /// The sum of a window's conditions: sum (c_j y_j + e_j q_j) - mu sum (y_j - g_j)^+ >= right.
  struct WindowSum {
    std::vector<Rational> c, e;
    Rational mu = 0, right = 0;
  };

  WindowSum window_sum(const std::vector<Multiple> &leaf) const {
    const tolerant_brute::Problem &problem = twins_.brute;
    WindowSum sum{std::vector<Rational>(k_), std::vector<Rational>(k_)};
    for (const Multiple &m : leaf) {
      const Rational n(m.multiplier);
      const auto shares = [&](std::size_t last, const Rational &by, const Rational &right) {
        for (std::size_t j = 0; j <= last; ++j)
          sum.c[j] += by;
        sum.right += by * right;
      };
      const auto counts = [&](const Rational &by, const Rational &right) {
        for (Rational &e : sum.e)
          e += by;
        sum.right += by * right;
      };
      switch (m.condition) {
      case TolerantCondition::whole_lo:
        shares(k_ - 1, n, 1);
        break;
      case TolerantCondition::whole_hi:
        shares(k_ - 1, -n, 1);
        break;
      case TolerantCondition::passing_lo:
        shares(m.j, n, problem.tolerance.passing.empty() ? Rational(0) : problem.tolerance.passing[m.j].lo);
        break;
      case TolerantCondition::passing_hi:
        shares(m.j, -n, problem.tolerance.passing.empty() ? Rational(1) : problem.tolerance.passing[m.j].hi);
        break;
      case TolerantCondition::excess_total:
        sum.mu += n;
        sum.right -= n * problem.tolerance.total.value() / 2;
        break;
      case TolerantCondition::weight:
        for (std::size_t j = 0; j < k_; ++j)
          sum.c[j] += n / problem.classes[j].factor;
        if (up_to_)
          sum.right += n * problem.demands.weight.value() / *up_to_;
        break;
      case TolerantCondition::at_least:
        counts(n, Rational(std::max(problem.demands.at_least, Integer(1))));
        break;
      case TolerantCondition::fewer:
        counts(-n, Rational(Integer(n_.value() - 1)));
        break;
      default:
        FAIL("a condition of leaves in a window");
      }
    }
    return sum;
  }

  /// Bounds on the shares of single classes, one after the other from both ends.
  std::vector<ShareBounds> single_shares() const {
    const tolerant_brute::Problem &problem = twins_.brute;
    const Rational half = problem.tolerance.total.value_or(Rational(2)) / 2;
    std::vector<ShareBounds> of(k_), sums(k_ + 1);
    sums[0] = {0, 0};
    Rational target = 0;
    for (std::size_t j = 0; j < k_; ++j) {
      target += problem.target[j];
      if (!problem.tolerance.retained.empty())
        of[j] = problem.tolerance.retained[j];
      if (!problem.tolerance.passing.empty())
        sums[j + 1] = problem.tolerance.passing[j];
      of[j] = {std::max(of[j].lo, Rational(problem.target[j] - half)),
               std::min(of[j].hi, Rational(problem.target[j] + half))};
      sums[j + 1] = {std::max(sums[j + 1].lo, Rational(target - half)),
                     std::min(sums[j + 1].hi, Rational(target + half))};
    }
    sums[k_] = {1, 1};
    for (std::size_t j = 0; j < k_; ++j)
      sums[j + 1] = {std::max(sums[j + 1].lo, Rational(sums[j].lo + of[j].lo)),
                     std::min(sums[j + 1].hi, Rational(sums[j].hi + of[j].hi))};
    for (std::size_t j = k_; j-- > 1;)
      sums[j] = {std::max(sums[j].lo, Rational(sums[j + 1].lo - of[j].hi)),
                 std::min(sums[j].hi, Rational(sums[j + 1].hi - of[j].lo))};
    for (std::size_t j = 0; j < k_; ++j)
      of[j] = {std::max(of[j].lo, Rational(sums[j + 1].lo - sums[j].hi)),
               std::min(of[j].hi, Rational(sums[j + 1].hi - sums[j].lo))};
    return of;
  }

  /// Tries all counts that a class can have, up to some beyond which its ends are constant or its value
  /// falls.
  bool is_without_match(const std::vector<Multiple> &leaf) {
    const WindowSum sum = window_sum(leaf);
    const std::vector<ShareBounds> shares = single_shares();
    Rational greatest = 0;
    bool is_reached = true;
    for (std::size_t j = 0; j < k_; ++j) {
      const tolerant_brute::Class &c = twins_.brute.classes[j];
      const Rational &l = shares[j].lo, &h = shares[j].hi, &g = twins_.brute.target[j];
      const Rational fall = up_to_ ? c.f / *up_to_ : Rational(0),
                     rise = above_ > 0 ? c.F / above_ : Rational(0);
      Integer q = least_[j], last = most_[j].value_or(Integer(-1));
      if (h <= 0)
        last = 0;
      std::optional<Rational> best;
      bool has_best = false, had_points = false;
      const int beyond = 3;
      for (int constant = 0; last < 0 || q <= last; ++q) {
        const bool is_above = q >= 1 && fall > 0 && q * fall >= h;
        const bool is_below = l > 0 && (q == 0 || (rise > 0 && q * rise <= l));
        if (is_above)
          break;
        if (is_below)
          continue;
        had_points = true;
        const Rational low = q == 0 ? Rational(0) : std::max(l, Rational(q * fall));
        const Rational high = q == 0 ? Rational(0) : rise > 0 ? std::min(h, Rational(q * rise)) : h;
        const bool low_is_open = q >= 1 && q * fall >= l, high_is_open = q >= 1 && rise > 0 && q * rise <= h;
        const auto see = [&](const Rational &y, bool is_in) {
          const Rational value =
              sum.c[j] * y + sum.e[j] * Rational(q) - sum.mu * std::max(Rational(0), Rational(y - g));
          has_best = best && value == *best ? has_best || is_in : !best || value > *best ? is_in : has_best;
          best = best ? std::max(*best, value) : value;
        };
        see(low, !low_is_open);
        see(high, !high_is_open);
        if (low < g && g < high)
          see(g, true);
        if (low < high)
          see((low + high) / 2, true);
        if (low < g && low < high)
          see((low + std::min(g, high)) / 2, true);
        if (high > g && low < high)
          see((high + std::max(g, low)) / 2, true);
        if (last < 0 && fall == 0 && (rise == 0 || q * rise > h) && q >= 1 && ++constant > beyond) {
          if (sum.e[j] > 0)
            return false;
          break;
        }
      }
      if (!had_points)
        return true;
      greatest += *best;
      is_reached = is_reached && has_best;
    }
    return greatest < sum.right || (greatest == sum.right && !is_reached);
  }

  bool is_contradiction(const std::vector<Multiple> &leaf) {
    left_.assign(3 * k_, 0);
    right_ = 0;
    bool strict = false;
    for (const Multiple &m : leaf) {
      if (m.multiplier <= 0)
        return false;
      add(m);
      strict = strict || m.condition == TolerantCondition::some_mass ||
               (m.condition == TolerantCondition::above_lower && least_[m.j] >= 1) ||
               (m.condition == TolerantCondition::above_lowers && least_of(m.i, m.j) >= 1);
    }
    return std::all_of(left_.begin(), left_.end(), [](const Rational &c) { return c == 0; }) &&
           (right_ > 0 || (right_ == 0 && strict));
  }

  Integer &least_of(std::size_t i, std::size_t j) { return i == j ? least_[j] : least_sum_[{i, j}]; }
  std::optional<Integer> &most_of(std::size_t i, std::size_t j) {
    return i == j ? most_[j] : most_sum_[{i, j}];
  }
  Rational &q(std::size_t j) { return left_[j]; }
  Rational &t(std::size_t j) { return left_[k_ + j]; }
  Rational &p(std::size_t j) { return left_[2 * k_ + j]; }
  /// by * (t_1 + ... + t_k)
  void add_mass(const Rational &by) {
    for (std::size_t j = 0; j < k_; ++j)
      t(j) += by;
  }

  void add(const Multiple &m) {
    const tolerant_brute::Problem &problem = twins_.brute;
    const Rational n(m.multiplier);
    const Rational unit = twins_.problem.unit();
    switch (m.condition) {
    case TolerantCondition::above_lower:
      t(m.j) += n;
      q(m.j) -= n * unit * problem.classes[m.j].f;
      break;
    case TolerantCondition::up_to_upper:
      t(m.j) -= n;
      q(m.j) += n * unit * problem.classes[m.j].F;
      break;
    case TolerantCondition::least_count:
      q(m.j) += n;
      right_ += n * Rational(least_[m.j]);
      break;
    case TolerantCondition::most_count:
      q(m.j) -= n;
      right_ -= n * Rational(most_[m.j].value());
      break;
    case TolerantCondition::least_sum:
      for (std::size_t j = m.i; j <= m.j; ++j)
        q(j) += n;
      right_ += n * Rational(least_of(m.i, m.j));
      break;
    case TolerantCondition::most_sum:
      for (std::size_t j = m.i; j <= m.j; ++j)
        q(j) -= n;
      right_ -= n * Rational(most_of(m.i, m.j).value());
      break;
    case TolerantCondition::above_lowers:
      for (std::size_t j = m.i; j <= m.j; ++j) {
        t(j) += n;
        q(j) -= n * unit * problem.classes[j].f;
      }
      break;
    case TolerantCondition::retained_lo:
      t(m.j) += n;
      add_mass(-n * problem.tolerance.retained.at(m.j).lo);
      break;
    case TolerantCondition::retained_hi:
      t(m.j) -= n;
      add_mass(n * problem.tolerance.retained.at(m.j).hi);
      break;
    case TolerantCondition::passing_lo:
      for (std::size_t i = 0; i <= m.j; ++i)
        t(i) += n;
      add_mass(-n * problem.tolerance.passing.at(m.j).lo);
      break;
    case TolerantCondition::passing_hi:
      for (std::size_t i = 0; i <= m.j; ++i)
        t(i) -= n;
      add_mass(n * problem.tolerance.passing.at(m.j).hi);
      break;
    case TolerantCondition::excess:
      p(m.j) += n;
      t(m.j) -= n;
      add_mass(n * problem.target[m.j]);
      break;
    case TolerantCondition::excess_sign:
      p(m.j) += n;
      break;
    case TolerantCondition::excess_total:
      for (std::size_t j = 0; j < k_; ++j)
        p(j) -= n;
      add_mass(n * problem.tolerance.total.value() / 2);
      break;
    case TolerantCondition::some_mass:
      add_mass(n);
      break;
    case TolerantCondition::weight:
      for (std::size_t j = 0; j < k_; ++j)
        t(j) += n / problem.classes[j].factor;
      right_ += n * problem.demands.weight.value() * unit;
      break;
    case TolerantCondition::at_least:
      for (std::size_t j = 0; j < k_; ++j)
        q(j) += n;
      right_ += n * Rational(std::max(problem.demands.at_least, Integer(1)));
      break;
    case TolerantCondition::fewer:
      for (std::size_t j = 0; j < k_; ++j)
        q(j) -= n;
      right_ -= n * Rational(Integer(n_.value() - 1));
      break;
    case TolerantCondition::whole_lo:
    case TolerantCondition::whole_hi:
      FAIL("a condition of windows in a leaf");
    }
  }

  const Twins &twins_;
  const Tree &tree_;
  std::optional<Integer> n_;
  std::size_t k_;
  std::vector<Integer> least_;
  std::vector<std::optional<Integer>> most_;
  std::map<std::pair<std::size_t, std::size_t>, Integer> least_sum_; ///< of classes i to j, i < j
  std::map<std::pair<std::size_t, std::size_t>, std::optional<Integer>> most_sum_;
  Rational above_ = 0; ///< the window of M, in the gradation's masses
  std::optional<Rational> up_to_;
  std::vector<Rational> left_; ///< coefficients of q, t and p
  Rational right_;
  std::size_t next_ = 0;
};

inline bool refutes(const Twins &twins, const TolerantResult &found) {
  std::optional<Integer> n;
  if (found.best)
    n = total(found.best->q);
  return TreeReader(twins, found.tree, n).holds();
}

inline Integer least_particles(const Twins &twins) {
  const TolerantResult found = tolerant_match(twins.problem);
  REQUIRE(found.complete);
  REQUIRE(found.best.has_value());
  check_match(twins, *found.best);
  CHECK(refutes(twins, found));
  return total(found.best->q);
}

using Kind = AskedTolerance::Kind;
const MassLaw by_length{1, 1};

} // namespace tolerant_twins
