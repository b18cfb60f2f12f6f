// The chain of a tolerance (Theorem 17). What comes in are the problem and its closure; what goes out are
// counts V_ij that every match has at least in classes i to j, a mass that every match exceeds, and the
// raises that led there.
//
// Three steps are repeated in rounds: Share, the classes hold at least l_ij of the mass M_0, for which they
// need so many particles; Sum, they hold what their parts hold; Mass, so many particles weigh more than f
// each, and are at most h_ij of all. Invariant: every match has the counts and the mass. Every step keeps
// it, and only raises, so that the last values do not depend on the order.
//
// The steps may have no end where there is no match (a positive cycle is looked for first, and other cases
// are not known); then limits end them, and what they reached is true. If the differences of V_1j are a
// match, it is the smallest (Theorem 17 (b)).

#include "match/tolerant_chain.hpp"

#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// A certificate has no more splits, each with its leaf.
constexpr std::size_t most_raises = longest_tree / 2;

} // namespace

TolerantChain::TolerantChain(const TolerantProblem &problem, const ShareClosure &shares, bool all_intervals,
                             const Limits &limits, const Watch &watch, const std::optional<Rational> &mass)
    : problem_(problem), shares_(shares), intervals_(problem.classes(), all_intervals), limits_(limits),
      watch_(
          watch.telling([this](Progress &known) { known.lower_bound = std::max(Integer(1), particles()); })),
      V_(intervals_.size()), lo_(intervals_.size()), hi_(intervals_.size()),
      keeps_raises_(limits.keep_proof) {
  for (std::size_t i = 0; i < problem.classes(); ++i)
    for (std::size_t j = i; j <= intervals_.last(i); ++j) {
      lo_[intervals_.place(i, j)] = shares.lo(i, j);
      hi_[intervals_.place(i, j)] = shares.hi(i, j);
    }
  start(mass);
  run();
}

/// The counts and the mass that are demanded.
void TolerantChain::start(const std::optional<Rational> &mass) {
  const std::size_t k = problem_.classes();
  for (std::size_t j = 0; j < k; ++j) {
    V_[intervals_.place(j, j)] = problem_.least(j);
    if (lo_[intervals_.place(j, j)] > 0)
      movable_.push_back(j);
  }
  if (mass)
    set_level_from(*mass);
  if (mass || !problem_.weight())
    return;
  for (std::size_t j = 0; j < k; ++j)
    heaviest_ = std::max(heaviest_, problem_.per_mass(j));
  std::vector<Rational> lighter;
  for (std::size_t j = 0; j < k; ++j)
    lighter.push_back((heaviest_ - problem_.per_mass(j)) *
                      ratio(lo_[intervals_.place(j, j)], shares_.unit()));
  per_mass_ = heaviest_ - sum(lighter);
  if (*problem_.weight() <= 0)
    return;
  set_level_from(Rational(*problem_.weight() / per_mass_));
}

/// M >= mass.
void TolerantChain::set_level_from(const Rational &mass) {
  const Rational level = mass / shares_.unit();
  mass_ = numerator(level);
  share_ = denominator(level);
  is_open_ = false;
  level_reason_ = Reason::weight;
}

bool TolerantChain::ends() {
  if (steps_ >= limits_.steps() || watch_.ends() || contradicts())
    return true;
  constexpr std::uint64_t many_steps = 1 << 16; // what is not enough for a match soon is
  return limits_.at_most && steps_ > many_steps && particles() > *limits_.at_most;
}

void TolerantChain::run() {
  raise_singles();
  raise_level();
  for (bool raised = true; raised && !contradicts();) {
    raised = sweep_singles();
    raised = raise_singles() || raised;
    raised = raise_intervals() || raised;
    raised = (!ends() && raise_level()) || raised;
    if (ends()) // a first round is short
      return;
  }
  complete_ = !contradicts();
}

/// Least count of the classes at `place`, of which the share is above 0, if so many particles hold F each
/// less `missing` in sum.
Integer TolerantChain::count_at_level(std::size_t place, const Integer &F, const Integer &missing) const {
  const Integer mass = lo_[place] * mass_ + share_ * missing;
  const Integer one = share_ * F;
  return is_open_ ? Integer(floor_div(mass, one) + 1) : ceil_div(mass, one);
}

void TolerantChain::raise(std::size_t i, std::size_t j, Integer n, Reason reason, std::uint32_t of) {
  ++steps_;
  if (keeps_raises_ && raises_.size() >= most_raises) {
    keeps_raises_ = false;
    std::vector<Raise>().swap(raises_);
  }
  if (keeps_raises_)
    raises_.push_back({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), reason, of, n});
  V_[intervals_.place(i, j)] = std::move(n);
}

void TolerantChain::raise_by_level(std::size_t i, std::size_t j, Integer n) {
  const std::size_t level = levels_.empty() ? 0 : levels_.size() - 1;
  raise(i, j, std::move(n), level_reason_, static_cast<std::uint32_t>(level));
}

/// From that count on a class needs no more mass than it has (Theorem 3 (c)).
Integer TolerantChain::settled_count(std::size_t j) const {
  const std::size_t place = intervals_.place(j, j);
  const Integer f = problem_.f(j) * lo_[place];
  return ceil_div(f, problem_.F(j) * hi_[place] - f);
}

/// Raises single classes as the sweep for the least match does: where that raises the level.
bool TolerantChain::sweep_singles() {
  bool raised = false;
  for (bool moved = true; moved && !ends();) {
    moved = false;
    std::size_t kept = 0;
    for (const std::size_t j : movable_) {
      const std::size_t place = intervals_.place(j, j);
      const Integer n = std::max(V_[place], count_at_level(place, problem_.F(j), 0));
      if (n > V_[place] && n * problem_.f(j) * share_ > mass_ * hi_[place]) {
        raise_by_level(j, j, n);
        raise_level_of(j, j, n * problem_.f(j));
        raised = moved = true;
      }
      if (n < settled_count(j))
        movable_[kept++] = j;
    }
    movable_.resize(kept);
  }
  return raised;
}

/// The counts of single classes at the level.
bool TolerantChain::raise_singles() {
  bool raised = false;
  for (std::size_t j = 0; j < problem_.classes(); ++j)
    if (const std::size_t place = intervals_.place(j, j); lo_[place] > 0)
      if (Integer n = count_at_level(place, problem_.F(j), 0); n > V_[place]) {
        raise_by_level(j, j, std::move(n));
        raised = true;
      }
  return raised;
}

bool TolerantChain::raise_intervals() {
  bool raised = false;
  if (!intervals_.are_all())
    return raise_intervals_from(0);
  for (std::size_t i = problem_.classes(); i-- > 0 && !ends();)
    raised = raise_intervals_from(i) || raised;
  return raised;
}

/// The steps of the intervals that begin at class i, each with those inside it known.
bool TolerantChain::raise_intervals_from(std::size_t i) {
  bool raised = false;
  Integer missing = 0; // by what is known of the intervals inside, sum F_b q_b is less than F_j N_ij
  Integer F = problem_.F(i);
  for (std::size_t j = i + 1; j < problem_.classes(); ++j) {
    if (problem_.F(j) > F) {
      missing += (problem_.F(j) - F) * count(i, j - 1);
      F = problem_.F(j);
    } else if (problem_.F(j) < F) {
      missing += (F - problem_.F(j)) * count(j, j);
    }
    const std::size_t place = intervals_.place(i, j);
    const std::size_t first = intervals_.are_all() ? i : j - 1; // else no other interval ends at j
    for (std::size_t b = j; b-- > first;)
      if (Integer n = count(i, b) + count(b + 1, j); n > V_[place]) {
        raise(i, j, std::move(n), Reason::sum, static_cast<std::uint32_t>(b));
        raised = true;
      }
    if (lo_[place] > 0)
      if (Integer n = count_at_level(place, F, missing); n > V_[place]) {
        raise_by_level(i, j, std::move(n));
        raised = true;
      }
  }
  return raised;
}

/// Of all intervals; of single classes only, where not all are known.
bool TolerantChain::raise_level() {
  bool raised = false;
  for (std::size_t i = 0; i < problem_.classes(); ++i)
    for (std::size_t j = i; j < (intervals_.are_all() ? problem_.classes() : i + 1); ++j)
      if (count(i, j) > 0)
        raised = raise_level_of(i, j, masses_of(i, j)) || raised;
  return raised;
}

/// The particles of classes i to j have more than `mass`.
bool TolerantChain::raise_level_of(std::size_t i, std::size_t j, const Integer &mass) {
  const Integer &share = hi_[intervals_.place(i, j)];
  const Level level{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), raises_.size()};
  if (share == 0) {
    empty_ = level;
    return false;
  }
  const Integer here = mass * share_, there = mass_ * share;
  if (here < there || (here == there && is_open_))
    return false;
  mass_ = mass;
  share_ = share;
  is_open_ = true;
  level_reason_ = Reason::particles;
  if (!levels_.empty() && (!keeps_raises_ || levels_.back().before == level.before))
    levels_.back() = level; // no raise is by the last one
  else
    levels_.push_back(level);
  return true;
}

/// What the particles of classes i to j have more than: sum f_b q_b, by all counts that are known.
Integer TolerantChain::masses_of(std::size_t i, std::size_t j) const {
  Integer mass = 0, f = problem_.f(j);
  for (std::size_t b = j; b > i; --b) {
    const Integer &next = problem_.f(b - 1);
    if (next < f) {
      mass += (f - next) * count(b, j);
      f = next;
    } else if (next > f) {
      mass += (next - f) * count(b - 1, b - 1);
    }
  }
  return mass + f * count(i, j);
}

std::vector<Integer> TolerantChain::differences() const {
  std::vector<Integer> q;
  for (std::size_t j = 0; j < problem_.classes(); ++j)
    q.push_back(j == 0 ? count(0, 0) : Integer(count(0, j) - count(0, j - 1)));
  return q;
}

} // namespace mdm
