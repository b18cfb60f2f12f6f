#include "match/count_bounds.hpp"

#include "match/problem.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>
#include <map>

namespace mdm {

/// A sum of conditions, written as such and as what they are summed up for.
class CountBounds::Leaf {
public:
  explicit Leaf(const CountBounds &bounds) : bounds_(bounds), problem_(bounds.problem_) {}

  void add(TolerantCondition condition, std::size_t j, const Rational &m) {
    if (m != 0)
      sum_[{condition, j}] += m;
  }

  /// F_j q_j - t_j >= 0 and q_j <= what is in force.
  void add_most(std::size_t j) {
    add(TolerantCondition::up_to_upper, j, 1);
    add(TolerantCondition::most_count, j, Rational(problem_.F(j)));
  }

  /// m (t_j - f_j q_j) >= 0 and q_j >= what is in force: a bound on t_j alone.
  void add_least(std::size_t j, const Rational &m) {
    add(TolerantCondition::above_lower, j, m);
    add(TolerantCondition::least_count, j, Rational(m * problem_.f(j)));
  }

  /// m (t_j - lower_j M) >= 0
  void add_lower(std::size_t j, const Rational &m) {
    switch (bounds_.lower_[j].origin) {
    case Origin::nothing:
      return add_least(j, m);
    case Origin::retained:
      return add(TolerantCondition::retained_lo, j, m);
    case Origin::passing:
      add_passing_lo(j, m);
      if (j > 0)
        add_passing_hi(j - 1, m);
      return;
    case Origin::total:
      return add_total(j, m, false);
    }
  }

  /// m (upper_j M - t_j) >= 0
  void add_upper(std::size_t j, const Rational &m) {
    switch (bounds_.upper_[j].origin) {
    case Origin::nothing:
      for (std::size_t i = 0; i < problem_.classes(); ++i)
        if (i != j)
          add_least(i, m);
      return;
    case Origin::retained:
      return add(TolerantCondition::retained_hi, j, m);
    case Origin::passing:
      add_passing_hi(j, m);
      if (j > 0)
        add_passing_lo(j - 1, m);
      return;
    case Origin::total:
      return add_total(j, m, true);
    }
  }

  TreeNode node() const {
    std::vector<Rational> multipliers;
    TreeNode node;
    for (const auto &[condition, m] : sum_) {
      multipliers.push_back(m);
      node.leaf.push_back({condition.first, condition.second, 0});
    }
    const CommonDenominator cleared(multipliers);
    for (std::size_t i = 0; i < node.leaf.size(); ++i)
      node.leaf[i].multiplier = cleared.numerators[i];
    return node;
  }

private:
  /// m (P_j - lo M) >= 0; all masses pass the upper sieve of the last class.
  void add_passing_lo(std::size_t j, const Rational &m) {
    if (j + 1 == problem_.classes())
      return;
    if (problem_.tolerance().passing[j].lo > 0)
      return add(TolerantCondition::passing_lo, j, m);
    for (std::size_t i = 0; i <= j; ++i)
      add_least(i, m);
  }

  /// m (hi M - P_j) >= 0
  void add_passing_hi(std::size_t j, const Rational &m) {
    if (j + 1 == problem_.classes())
      return;
    if (problem_.tolerance().passing[j].hi < 1)
      return add(TolerantCondition::passing_hi, j, m);
    for (std::size_t i = j + 1; i < problem_.classes(); ++i)
      add_least(i, m);
  }

  /// One class's share is off by at most half of the total: its own excess is, or all others' together.
  void add_total(std::size_t j, const Rational &m, bool own) {
    add(TolerantCondition::excess_total, 0, m);
    for (std::size_t i = 0; i < problem_.classes(); ++i)
      add((i == j) == own ? TolerantCondition::excess : TolerantCondition::excess_sign, i, m);
  }

  const CountBounds &bounds_;
  const TolerantProblem &problem_;
  std::map<std::pair<TolerantCondition, std::size_t>, Rational> sum_;
};

CountBounds::CountBounds(const TolerantProblem &problem, const Limits &limits, const Watch &watch)
    : problem_(problem), keeps_steps_(limits.keep_proof) {
  for (std::size_t j = 0; j < problem.classes(); ++j) {
    q_.push_back(problem.least(j));
    lower_.push_back(lower(j));
    upper_.push_back(upper(j));
  }
  if (contradict()) // no share curve, which the search finds at once
    return;
  start();
  sweep(limits,
        watch.telling([this](Progress &known) { known.lower_bound = std::max(Integer(1), total(q_)); }));
}

CountBounds::ShareBound CountBounds::lower(std::size_t j) const {
  const Tolerance &tolerance = problem_.tolerance();
  ShareBound best{0, Origin::nothing};
  const auto raise_to = [&best](const Rational &share, Origin origin) {
    if (share > best.share)
      best = {share, origin};
  };
  if (!tolerance.retained.empty())
    raise_to(tolerance.retained[j].lo, Origin::retained);
  if (const std::vector<ShareBounds> &passing = tolerance.passing; !passing.empty())
    raise_to((j + 1 == passing.size() ? Rational(1) : passing[j].lo) -
                 (j == 0 ? Rational(0) : passing[j - 1].hi),
             Origin::passing);
  if (tolerance.total)
    raise_to(problem_.target()[j] - *tolerance.total / 2, Origin::total);
  return best;
}

CountBounds::ShareBound CountBounds::upper(std::size_t j) const {
  const Tolerance &tolerance = problem_.tolerance();
  ShareBound best{1, Origin::nothing};
  const auto lower_to = [&best](const Rational &share, Origin origin) {
    if (share < best.share)
      best = {share, origin};
  };
  if (!tolerance.retained.empty())
    lower_to(tolerance.retained[j].hi, Origin::retained);
  if (const std::vector<ShareBounds> &passing = tolerance.passing; !passing.empty())
    lower_to((j + 1 == passing.size() ? Rational(1) : passing[j].hi) -
                 (j == 0 ? Rational(0) : passing[j - 1].lo),
             Origin::passing);
  if (tolerance.total)
    lower_to(problem_.target()[j] + *tolerance.total / 2, Origin::total);
  return best;
}

bool CountBounds::contradict() const {
  for (std::size_t j = 0; j < q_.size(); ++j)
    if (upper_[j].share < lower_[j].share || (upper_[j].share == 0 && q_[j] > 0))
      return true;
  return false;
}

/// The particles that the weight demands, or mass alone.
void CountBounds::start() {
  if (problem_.weight()) {
    for (std::size_t j = 0; j < q_.size(); ++j)
      heaviest_ = std::max(heaviest_, problem_.per_mass(j));
    std::vector<Rational> lighter;
    for (std::size_t j = 0; j < q_.size(); ++j)
      lighter.push_back((heaviest_ - problem_.per_mass(j)) * lower_[j].share);
    per_mass_ = heaviest_ - sum(lighter);
  }
  for (std::size_t j = 0; j < q_.size(); ++j) {
    if (lower_[j].share == 0)
      continue;
    const Integer by_weight =
        per_mass_ > 0 ? ceil(Rational(lower_[j].share * *problem_.weight() / (per_mass_ * problem_.F(j))))
                      : Integer(0);
    if (by_weight > std::max(q_[j], Integer(1)))
      raise(j, by_weight, Reason::weight);
    else if (q_[j] < 1)
      raise(j, 1, Reason::mass);
  }
}

/// Least count of class j at masses above the level.
Integer CountBounds::count(std::size_t j) const {
  return floor(Rational(level_ * lower_[j].share / problem_.F(j))) + 1;
}

void CountBounds::raise(std::size_t j, const Integer &n, Reason reason) {
  if (keeps_steps_ && 2 * steps_.size() < longest_tree)
    steps_.push_back({j, n, reason, source_});
  else
    too_long_ = true;
  q_[j] = n;
}

/// True if the particles of class j need more mass than the level.
bool CountBounds::sets_level(std::size_t j) {
  if (q_[j] < 1 || upper_[j].share == 0)
    return false;
  const Rational least = q_[j] * Rational(problem_.f(j)) / upper_[j].share;
  if (least <= level_)
    return false;
  level_ = least;
  source_ = j;
  return true;
}

void CountBounds::sweep(const Limits &limits, const Watch &watch) {
  std::vector<std::size_t> movable;
  for (std::size_t j = 0; j < q_.size(); ++j) {
    sets_level(j);
    if (lower_[j].share > 0)
      movable.push_back(j);
  }
  std::uint64_t raises = 0;
  const auto interrupted = [&] { return raises >= limits.steps() || watch.ends(); };
  for (bool moved = level_ > 0; moved;) {
    moved = false;
    std::size_t kept = 0;
    for (const std::size_t j : movable) {
      if (interrupted())
        return raise_all();
      const Integer n = std::max(q_[j], count(j));
      if (n > q_[j] && n * Rational(problem_.f(j)) / upper_[j].share > level_) {
        raise(j, n, Reason::particles);
        sets_level(j);
        ++raises;
        moved = true;
      }
      if (n < settled_count(j))
        movable[kept++] = j;
    }
    movable.resize(kept);
    constexpr std::uint64_t many_raises = 1 << 16;
    if (limits.at_most && raises > many_raises) {
      raise_all();
      if (total(q_) > *limits.at_most)
        return;
    }
  }
  raise_all();
}

/// From that count on a class needs no more mass than it has (Theorem 3 (c)).
Integer CountBounds::settled_count(std::size_t j) const {
  const Rational f = problem_.f(j) * lower_[j].share;
  return ceil(Rational(f / (problem_.F(j) * upper_[j].share - f)));
}

/// The counts of all classes above the level.
void CountBounds::raise_all() {
  for (std::size_t j = 0; j < q_.size() && level_ > 0; ++j)
    if (lower_[j].share > 0)
      if (const Integer n = count(j); n > q_[j])
        raise(j, n, Reason::particles);
}

/// Fewer than step.n particles in its class contradict what is known: the counts q, the shares and the
/// weight.
TreeNode CountBounds::refutation(const Step &step) const {
  Leaf leaf(*this);
  leaf.add_most(step.j);
  leaf.add_lower(step.j, 1);
  const Rational &share = lower_[step.j].share;
  switch (step.reason) {
  case Reason::mass:
    leaf.add(TolerantCondition::some_mass, 0, share);
    break;
  case Reason::weight: {
    const Rational m = share / per_mass_;
    leaf.add(TolerantCondition::weight, 0, m);
    for (std::size_t i = 0; i < q_.size(); ++i)
      leaf.add_lower(i, Rational(m * (heaviest_ - problem_.per_mass(i))));
    break;
  }
  case Reason::particles: {
    const Rational m = share / upper_[step.of].share;
    leaf.add_least(step.of, m);
    leaf.add_upper(step.of, m);
    break;
  }
  }
  return leaf.node();
}

Tree CountBounds::tree() const {
  Tree tree;
  std::size_t size = 0;
  const auto append = [&](TreeNode node) {
    size += 1 + node.leaf.size();
    tree.push_back(std::move(node));
  };
  for (const Step &step : steps_) {
    append({step.j, step.n, {}});
    append(refutation(step));
    if (too_long_ || size > longest_tree)
      return {};
  }
  TreeNode enough;
  for (std::size_t j = 0; j < q_.size(); ++j)
    enough.leaf.push_back({TolerantCondition::least_count, j, 1});
  enough.leaf.push_back({TolerantCondition::fewer, 0, 1});
  append(std::move(enough));
  return tree;
}

} // namespace mdm
