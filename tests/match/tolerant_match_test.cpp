#include "catch.hpp"
#include "match/central_masses.hpp"
#include "match/least_match.hpp"
#include "match/problem_of.hpp"
#include "match/tolerant_chain_proof.hpp"
#include "match/tolerant_match.hpp"
#include "match/tolerant_search.hpp"
#include "plain_gradation.hpp"
#include "tolerant_brute_force.hpp"

#include <mdm/match/solve.hpp>

using namespace mdm;

namespace {

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

Tolerance tolerance_of(const Gradation &g, AskedTolerance::Kind kind, const Rational &percent) {
  return mdm::tolerance_of(g, {{kind, percent}}, std::nullopt, 1);
}

/// Small classes that touch, some of them empty, widths from narrow to wide, sometimes from 0 on.
Gradation random_gradation(std::mt19937_64 &random, std::size_t most_classes) {
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

Rational random_percent(std::mt19937_64 &random) {
  const Rational percents[] = {0, 1, 2, 5, ratio(25, 2), 10, 20, 25, 25, 30, ratio(100, 3), 50, 75, 100};
  return percents[random() % 14];
}

/// Bounds in tenths on some sieves, now and then contradictory.
Tolerance random_band(std::size_t classes, std::mt19937_64 &random) {
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

Tolerance random_tolerance(const Gradation &g, std::mt19937_64 &random) {
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

Twins random_twins(std::mt19937_64 &random, std::size_t most_classes) {
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
void check_match(const Twins &twins, const TolerantMatch &match) {
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
    if (!node.leaf.empty())
      return is_contradiction(node.leaf);
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
  std::vector<Rational> left_; ///< coefficients of q, t and p
  Rational right_;
  std::size_t next_ = 0;
};

bool refutes(const Twins &twins, const TolerantResult &found) {
  std::optional<Integer> n;
  if (found.best)
    n = total(found.best->q);
  return TreeReader(twins, found.tree, n).holds();
}

Integer least_particles(const Twins &twins) {
  const TolerantResult found = tolerant_match(twins.problem);
  REQUIRE(found.complete);
  REQUIRE(found.best.has_value());
  check_match(twins, *found.best);
  CHECK(refutes(twins, found));
  return total(found.best->q);
}

using Kind = AskedTolerance::Kind;
const MassLaw by_length{1, 1};

} // namespace

TEST_CASE("a lower bound is strict only for a class that holds particles") {
  // (0, 2], (2, 5], (5, 9] within 25 points of (50, 25, 25): the middle class may be empty, and then holds
  // no mass. Strict everywhere would give 4, closed everywhere 2.
  const Gradation g = gradation({0, 2, 5, 9}, {2, 1, 1, 0});
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::retained, 25), {}}) == 3);
}

TEST_CASE("whole counts on excluded bounds are no match") {
  // (1, 2], (2, 3] within 10 points in sum of (20, 80): one particle of 2 and one of 3 touch the bounds.
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::total, 10), {}}) == 3);
}

TEST_CASE("a sample has at least one particle") {
  const Gradation g = gradation({0, 2, 5, 9}, {2, 1, 1, 0});
  for (const Kind kind : {Kind::retained, Kind::passing})
    CHECK(least_particles({g, by_length, tolerance_of(g, kind, 100), {}}) == 1);
  CHECK(least_particles({g, by_length, tolerance_of(g, Kind::total, 100), {}}) == 1);
}

TEST_CASE("a tolerance of nothing is the exact problem") {
  std::mt19937_64 random(41);
  for (int i = 0; i < 200; ++i) {
    const Gradation g = random_gradation(random, 4);
    const Integer exact = total(least_match(Problem(g, {}, 1)).q);
    for (const Kind kind : {Kind::retained, Kind::passing, Kind::total})
      CHECK(least_particles({g, {}, tolerance_of(g, kind, 0), {}}) == exact);
  }
}

TEST_CASE("a volume is that of the particles, whatever their density") {
  // Spheres of up to 3: 27 in units of pi / 6 each, although one of them weighs 4 times 27.
  Gradation::Data data;
  data.sizes = {1, 2, 3};
  data.masses = {1, 1, 0};
  data.factors = {1, 4, 1};
  const Gradation g((Gradation::Data(data)));
  TolerantDemands demands;
  demands.weight = 81;
  CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 100), demands}) == 3);
  demands.weight = 82;
  CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 100), demands}) == 4);
}

TEST_CASE("a volume within no tolerance is that of the exact problem, densities included") {
  std::mt19937_64 random(45);
  int with_factors = 0;
  for (int i = 0; i < 150; ++i) {
    const Gradation g = random_gradation(random, 4);
    with_factors += g.has_factors() ? 1 : 0;
    Question exact;
    exact.solids = SolidsVolume{Rational(static_cast<int>(1 + random() % 900))};
    Question tolerant = exact;
    tolerant.tolerances = {{Kind::retained, 0}};
    const Match found = solve(g, tolerant, {});
    REQUIRE(found.status == Status::optimal);
    CHECK(found.particles() == solve(g, exact, {}).particles());
  }
  CHECK(with_factors >= 32);
}

TEST_CASE("the least number within a tolerance is that of enumeration") {
  std::mt19937_64 random(42);
  int none = 0, decided = 0;
  for (int i = 0; i < 1000; ++i) {
    const Twins twins = random_twins(random, i % 4 == 0 ? 4 : 3);
    const TolerantResult found = tolerant_match(twins.problem);
    REQUIRE(found.complete);
    CHECK(refutes(twins, found));
    const int limit = twins.brute.classes.size() == 4 ? 7 : 11;
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, limit);
    INFO("problem " << i);
    if (!found.best) {
      ++none;
      CHECK_FALSE(least.has_value());
      continue;
    }
    check_match(twins, *found.best);
    CHECK(twins.problem.is_match(found.best->q, found.best->t));
    CHECK(found.lower_bound == total(found.best->q));
    if (least)
      CHECK(total(found.best->q) == *least);
    else
      CHECK(total(found.best->q) > limit);
    decided += least ? 1 : 0;
  }
  CHECK(decided >= 900);
  CHECK(none >= 25);
}

TEST_CASE("a search without the chain's bounds has the least number of enumeration, and proves it") {
  std::mt19937_64 random(48);
  int decided = 0, split = 0;
  for (int i = 0; i < 800; ++i) {
    const Twins twins = random_twins(random, i % 4 == 0 ? 4 : 3);
    const ShareClosure shares(twins.problem);
    if (shares.contradicts())
      continue;
    CountBounds bounds;
    for (std::size_t j = 0; j < twins.problem.classes(); ++j)
      bounds.classes.push_back({twins.problem.least(j), std::nullopt});
    std::optional<TolerantMatch> best;
    TolerantSearch search(twins.problem, shares, bounds, 0, nullptr, best, {}, {});
    search.run();
    INFO("problem " << i);
    REQUIRE(search.is_complete());
    split += search.nodes() > 1 ? 1 : 0;
    const int limit = twins.brute.classes.size() == 4 ? 7 : 11;
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, limit);
    if (!best) {
      CHECK_FALSE(least.has_value());
      CHECK(TreeReader(twins, search.tree(), std::nullopt).holds());
      continue;
    }
    const Integer n = total(best->q);
    check_match(twins, *best);
    CHECK(TreeReader(twins, search.tree(), n).holds());
    CHECK_FALSE(TreeReader(twins, search.tree(), Integer(n + 1)).holds());
    CHECK((least ? n == *least : n > limit));
    decided += least ? 1 : 0;
  }
  CHECK(decided >= 650);
  CHECK(split >= 200);
}

TEST_CASE("a search that is stopped leaves a match and a bound that are true") {
  std::mt19937_64 random(43);
  int stopped = 0;
  for (int i = 0; i < 6000; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult all = tolerant_match(twins.problem);
    for (std::uint64_t nodes = 0; nodes < std::min<std::uint64_t>(all.nodes, 12); ++nodes) {
      Limits limits;
      limits.node_limit = nodes;
      const TolerantResult part = tolerant_match(twins.problem, limits);
      CHECK(part.nodes == nodes);
      if (part.complete) { // its bound was as many as the best has
        CHECK(total(part.best->q) == total(all.best->q));
        continue;
      }
      CHECK_FALSE(part.tree.empty());
      CHECK(part.proved == part.lower_bound);
      ++stopped;
      if (part.best) {
        check_match(twins, *part.best);
        CHECK(part.lower_bound <= total(part.best->q));
      }
      if (all.best)
        CHECK(part.lower_bound <= total(all.best->q));
    }
  }
  CHECK(stopped >= 800);
}

TEST_CASE("a search has the same result twice") {
  std::mt19937_64 random(44);
  for (int i = 0; i < 100; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult a = tolerant_match(twins.problem), b = tolerant_match(twins.problem);
    CHECK(a.nodes == b.nodes);
    CHECK(a.tree.size() == b.tree.size());
    CHECK(a.best.has_value() == b.best.has_value());
    if (a.best) {
      CHECK(a.best->q == b.best->q);
      CHECK(a.best->t == b.best->t);
    }
  }
}

TEST_CASE("central masses are a match, and fail where there is none") {
  std::mt19937_64 random(45);
  for (int i = 0; i < 300; ++i) {
    const Twins twins = random_twins(random, 4);
    const TolerantResult found = tolerant_match(twins.problem);
    if (!found.best)
      continue;
    const auto t = central_masses(twins.problem, found.best->q, twins.brute.demands.weight, ratio(1, 1000));
    REQUIRE(t.has_value());
    check_match(twins, {found.best->q, *t});
  }
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  const Twins twins(g, by_length, tolerance_of(g, Kind::total, 10), {});
  CHECK_FALSE(central_masses(twins.problem, {1, 1}, std::nullopt, 0).has_value());
}

TEST_CASE("a band without a curve has no match of any number") {
  const Gradation g = gradation({0, 1, 2, 4}, {1, 1, 1, 0});
  const Twins crossing(g, {}, {{}, {{ratio(1, 2), 1}, {0, ratio(1, 4)}, {0, 1}}, {}}, {});
  const Twins not_all(g, {}, {{}, {{0, 1}, {0, 1}, {0, ratio(9, 10)}}, {}}, {});
  const Twins below_nothing(g, {}, {{{0, 1}, {ratio(1, 2), ratio(1, 4)}, {0, 1}}, {}, {}}, {});
  for (const Twins *twins : {&crossing, &not_all, &below_nothing}) {
    const TolerantResult found = tolerant_match(twins->problem);
    CHECK(found.complete);
    CHECK_FALSE(found.best.has_value());
    CHECK(refutes(*twins, found));
  }
}

TEST_CASE("many particles can be asked for without an end of the search") {
  const Gradation g = gradation({1, 2, 3}, {2, 8, 0});
  for (const Integer &n : {Integer(4), Integer(11), Integer(1000), power_of_ten(18)})
    CHECK(least_particles({g, {}, tolerance_of(g, Kind::retained, 2), {1, n, {}}}) == n);
}

TEST_CASE("the chain's counts are proved, and are not above the least number") {
  std::mt19937_64 random(46);
  int reached = 0, more = 0, none = 0;
  for (int i = 0; i < 1500; ++i) {
    const Twins twins = random_twins(random, 4);
    const ShareClosure shares(twins.problem);
    const std::optional<int> least = tolerant_brute::least_particles(twins.brute, 7);
    if (shares.contradicts()) {
      CHECK(TreeReader(twins, share_contradiction(twins.problem, shares), std::nullopt).holds());
      CHECK_FALSE(least.has_value());
      ++none;
      continue;
    }
    for (const bool all_intervals : {false, true}) {
      const TolerantChain chain(twins.problem, shares, all_intervals, {}, {});
      CHECK(chain.complete() != chain.contradicts());
      if (chain.contradicts()) {
        CHECK(TreeReader(twins, chain_contradiction(chain), std::nullopt).holds());
        CHECK_FALSE(least.has_value());
        continue;
      }
      CHECK(TreeReader(twins, chain_tree(chain), chain.particles()).holds());
      CHECK_FALSE(TreeReader(twins, chain_tree(chain), Integer(chain.particles() + 1)).holds());
      if (!least)
        continue;
      CHECK(chain.particles() <= *least);
      reached += chain.particles() == *least ? 1 : 0;
      more += chain.particles() > 1 ? 1 : 0;
    }
  }
  CHECK(reached >= 1500);
  CHECK(more >= 1200);
  CHECK(none >= 20);
}

TEST_CASE("counts that a volume demands are proved, whatever the densities") {
  std::mt19937_64 random(47);
  for (int i = 0; i < 300; ++i) {
    const Gradation g = random_gradation(random, 4);
    TolerantDemands demands;
    demands.weight = static_cast<int>(1 + random() % 900);
    const Kind kinds[] = {Kind::retained, Kind::passing, Kind::total};
    const Twins twins(g, {}, tolerance_of(g, kinds[random() % 3], random_percent(random)), demands);
    const ShareClosure shares(twins.problem);
    REQUIRE_FALSE(shares.contradicts());
    for (const bool all_intervals : {false, true}) {
      const TolerantChain chain(twins.problem, shares, all_intervals, {}, {});
      CHECK(TreeReader(twins, chain_tree(chain), chain.particles()).holds());
    }
  }
}

namespace {

std::vector<Rational> in_units_of(const TolerantProblem &problem, std::vector<Rational> masses) {
  for (Rational &t : masses)
    t *= problem.unit();
  return masses;
}

/// Classes of the same ratio, as narrow as a sieve analysis never has them.
Gradation geometric(int classes) {
  std::vector<Rational> sizes{1}, masses;
  for (int j = 0; j < classes; ++j) {
    sizes.push_back(ratio(floor(Rational(sizes.back() * 10400)), 10000));
    masses.emplace_back(1 + j * 7 % 11);
  }
  masses.emplace_back(0);
  return gradation(std::move(sizes), std::move(masses));
}

} // namespace

TEST_CASE("a tolerance of nothing needs no search, however many classes there are") {
  const Gradation g = geometric(100);
  const Match exact = solve(g);
  for (const Kind kind : {Kind::retained, Kind::passing, Kind::total}) {
    Question question;
    question.tolerances = {{kind, 0}};
    const Match m = solve(g, question);
    CHECK(m.status == Status::optimal);
    CHECK(m.particles() == exact.particles());
    const Twins twins(g, {}, *m.tolerance, {});
    const TolerantMatch found{m.sample->quantities, in_units_of(twins.problem, class_masses(m))};
    const TolerantResult again = tolerant_match(twins.problem, {}, found);
    CHECK(again.nodes == 0);
    CHECK(refutes(twins, again));
    CHECK(TreeReader(twins, std::get<Tree>(*m.evidence()), *m.particles()).holds());
  }
}

TEST_CASE("a deadline ends a search before its first node is done") {
  Question question;
  question.tolerances = {{Kind::passing, ratio(1, 2)}};
  SolveOptions options;
  const auto start = std::chrono::steady_clock::now();
  options.limits.deadline = start + std::chrono::milliseconds(100);
  const Match m = solve(geometric(150), question, options);
  CHECK(std::chrono::steady_clock::now() - start < std::chrono::seconds(10));
  CHECK(m.status == Status::feasible);
  CHECK(m.lower_bound > 1);
  CHECK(m.lower_bound <= m.particles());
}

TEST_CASE("where a search would not fit into memory the exact match is the answer") {
  const Gradation g = geometric(1100);
  Question question;
  question.tolerances = {{Kind::retained, 1}};
  const Match m = solve(g, question);
  CHECK(m.status == Status::feasible);
  CHECK(m.particles() == solve(g).particles());
  CHECK(m.lower_bound < m.particles());
  REQUIRE(m.notes.size() >= 1);
  CHECK(m.notes.back().find("memory") != std::string::npos);
}

TEST_CASE("more particles than may be end a search") {
  const Gradation g = gradation({4, 5, 6, 7, 8}, {1, 3, 2, 5, 0});
  Question question;
  question.tolerances = {{Kind::retained, 1}};
  const Match least = solve(g, question);
  REQUIRE(least.status == Status::optimal);
  SolveOptions options;
  options.at_most = *least.particles() - 1;
  const Match none = solve(g, question, options);
  CHECK(none.status == Status::none);
  CHECK(none.lower_bound > *options.at_most);
  options.at_most = least.particles();
  CHECK(solve(g, question, options).status == Status::optimal);
  options.at_most = 1;
  CHECK(solve(g, question, options).status == Status::none);
  const TolerantProblem problem = tolerant_problem_of(least);
  Limits limits;
  limits.at_most = 1;
  CHECK(tolerant_match(problem, limits).nodes <= tolerant_match(problem).nodes);
}
