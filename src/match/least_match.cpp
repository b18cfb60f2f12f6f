// The sweep: the least match, class by class. What comes in is the integer problem; what goes out are the
// least counts and the chain, the steps that prove them.
//
// Kept is a lower bound L on the scale of every match. Class j needs at least the count q_j(L) above L, and
// q_j(L) particles weigh more than q_j(L) f_j: if that is above L m_j, L rises to it. Invariant: no match
// has a scale up to L, so none has fewer than q_j(L) particles in class j (Theorem 3 (a)). When no class
// raises L, these counts are a match, and hence the least (Theorem 3 (b)).
//
// It ends because a class with q (F - f) >= f, a settled one, raises no more: there are at most 1 + sum
// (ceil(f / (F - f)) - r) steps, whatever the masses are (Theorem 3 (d)). Settled classes leave the list,
// so that rounds become short.
//
// Doubles decide a comparison where their error allows it, integers of 128 bits elsewhere, and where these
// overflow the sweep starts again in integers of any length (Lemma 11). Which of them decides never changes
// a step.

#include "match/least_match.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace mdm {
namespace {

/// Relative margin for the doubles below: 32u. A level is off by at most 8u, a quotient by at most 14u
/// (lower 5u, count 2u, per_upper 5u, an operation u each) plus terms in u^2, with 1/2 added by u more.
constexpr double level_margin = 0x1p-48;

/// Below this adding 2^52 rounds to an integer.
constexpr double largest_quotient = 0x1p50;

const Integer &to_integer(const Integer &n) {
  return n;
}

Integer to_integer(const Int128 &n) {
  return n.to_integer();
}

/// The lower bound L on the scale and what every class needs above it.
template <class Int>
class Sweep {
public:
  Sweep(const SweepProblem<Int> &problem, const Limits &limits, const Watch &watch)
      : problem_(problem), limits_(limits), watch_(watch.telling([this](Progress &known) { tell(known); })) {}

  Swept<Int> run() {
    Swept<Int> result;
    result.complete = start(result.chain) && rounds(result.chain);
    result.steps = steps_;
    result.q.reserve(problem_.classes.size());
    for (const Class &c : problem_.classes)
      result.q.push_back(count(c).n);
    return result;
  }

private:
  using Class = SweepClass<Int>;

  /// A number of particles, also as a double within 2u.
  struct Count {
    Int n;
    double approx;
  };

  /// L = n^b f / mass of a class; 0 before the first.
  struct Level {
    Int n = 0;
    const Class *of = nullptr;
    double approx = 0;
  };

  /// n^b f, the numerator of a level.
  Int product(const Class &c, const Int &n) const {
    return problem_.b == 1 ? n * c.f : power(n, problem_.b) * c.f;
  }

  /// The largest integer q with q^b F / mass <= L, where doubles do not decide.
  Int exact_count_below(const Class &c) const {
    if (level_.of == nullptr)
      return 0;
    const Int quotient = floor_div(product(*level_.of, level_.n) * c.mass, level_.of->mass * c.F);
    return problem_.b == 1 ? quotient : floor_root(quotient, problem_.b);
  }

  /// Least count that class c needs at scales above L.
  Count count(const Class &c) const {
    const double y = level_.approx * c.per_upper;
    if (y < largest_quotient) {
      // floor(y) + 1 is the integer nearest to y + 1/2, and has neither a call nor a branch.
      const double middle = y + 0.5;
      const double n = (middle + 0x1p52) - 0x1p52;
      if (std::abs(middle - n) < 0.5 - middle * level_margin)
        return at_least_floor(c, {Int(static_cast<std::int64_t>(n)), n});
    }
    const Int n = exact_count_below(c) + Int(1);
    return at_least_floor(c, {n, to_double(n)});
  }

  static Count at_least_floor(const Class &c, Count count) {
    return count.n < c.floor ? Count{c.floor, c.floor_approx} : count;
  }

  /// True if n^b f / mass > L; `approx` is its double.
  bool rises(const Class &c, const Int &n, double approx) const {
    if (approx < level_.approx * (1 - level_margin))
      return false;
    return approx > level_.approx * (1 + level_margin) || exactly_above(c, n);
  }

  bool exactly_above(const Class &c, const Int &n) const {
    const Int above = product(c, n);
    return level_.of == nullptr ? above > Int(0)
                                : above * level_.of->mass > product(*level_.of, level_.n) * c.mass;
  }

  bool interrupted() { return steps_ >= next_look_ && look(); }

  /// True if a limit is reached; else sets the next look.
  [[gnu::noinline]] bool look() {
    if (steps_ >= limits_.steps())
      return true;
    constexpr std::uint64_t between_looks = 1024;
    next_look_ = std::min(steps_ + between_looks, limits_.steps());
    return watch_.ends() || (limits_.at_most && has_too_many());
  }

  void take_step(Steps &chain, std::uint32_t j) {
    ++steps_;
    if (limits_.keep_proof)
      chain.push_back(j);
  }

  /// Looked at when the steps have doubled: a sum over all classes is long beside a step.
  bool has_too_many() const {
    constexpr std::uint64_t many_steps = 1 << 16;
    if (steps_ < many_steps || (steps_ & (steps_ - 1)) != 0)
      return false;
    return counts() > *limits_.at_most;
  }

  /// Counts for the caller may be too long where those of the sweep are not: then an earlier bound is told.
  void tell(Progress &known) {
    try {
      told_ = counts();
    } catch (const Int128Overflow &) { // the sweep goes on without them
    }
    known.steps = steps_;
    known.lower_bound = told_;
  }

  /// The particles that all classes need above L: no match has fewer.
  Integer counts() const {
    Integer sum = 0;
    for (const Class &c : problem_.classes)
      sum += to_integer(count(c).n);
    return sum;
  }

  /// First step: the largest level of the floors.
  bool start(Steps &chain) {
    std::uint32_t highest = 0;
    for (std::uint32_t j = 0; j < problem_.classes.size(); ++j) {
      const Class &c = problem_.classes[j];
      const double approx = c.floor_approx * c.lower;
      if (rises(c, c.floor, approx)) {
        level_ = Level{c.floor, &c, approx};
        highest = j;
      }
      if (c.floor < c.settled)
        movable_.push_back(j);
    }
    if (level_.of == nullptr)
      return true;
    const Level first = std::exchange(level_, Level{});
    if (interrupted())
      return false;
    level_ = first;
    take_step(chain, highest);
    return true;
  }

  /// Rounds over the movable classes until none raises L. False if interrupted.
  bool rounds(Steps &chain) {
    for (bool moved = true; moved;) {
      moved = false;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < movable_.size(); ++i) {
        const std::uint32_t j = movable_[i];
        const Class &c = problem_.classes[j];
        const Count n = count(c);
        const double approx = n.approx * c.lower;
        if (rises(c, n.n, approx)) {
          if (interrupted())
            return false;
          level_ = Level{n.n, &c, approx};
          take_step(chain, j);
          moved = true;
        }
        if (n.n < c.settled)
          movable_[kept++] = j;
      }
      movable_.resize(kept);
    }
    return true;
  }

  const SweepProblem<Int> &problem_;
  const Limits &limits_;
  const Watch watch_;
  Integer told_ = 1; ///< the last bound that the caller was told
  Level level_;
  std::vector<std::uint32_t> movable_;
  std::uint64_t steps_ = 0;
  std::uint64_t next_look_ = 0; ///< steps
};

LeastMatch in_integers(Swept<Int128> swept) {
  LeastMatch match;
  match.q.reserve(swept.q.size());
  for (const Int128 &n : swept.q)
    match.q.push_back(n.to_integer());
  match.chain = std::move(swept.chain);
  match.steps = swept.steps;
  match.complete = swept.complete;
  return match;
}

} // namespace

template <class Int>
Swept<Int> sweep(const SweepProblem<Int> &problem, const Limits &limits, const Watch &watch) {
  return Sweep<Int>(problem, limits, watch).run();
}

template Swept<Int128> sweep(const SweepProblem<Int128> &, const Limits &, const Watch &);
template Swept<Integer> sweep(const SweepProblem<Integer> &, const Limits &, const Watch &);

LeastMatch least_match(const Problem &problem, const Limits &limits, const Watch &watch) {
  try {
    return in_integers(sweep(SweepProblem<Int128>(problem), limits, watch));
  } catch (const Int128Overflow &) {
    return sweep(SweepProblem<Integer>(problem), limits, watch);
  }
}

LeastMatch least_match(const Problem &problem, const Limits &limits) {
  return least_match(problem, limits, Watch(limits.deadline));
}

Chain chain_of(Steps steps, const Rational &above, const Problem &problem) {
  Chain chain{std::nullopt, std::move(steps)};
  if (above > 0)
    chain.above = above * problem.scale_unit();
  for (std::uint32_t &step : chain.steps)
    step = static_cast<std::uint32_t>(problem.classes()[step].index);
  return chain;
}

std::vector<Integer> some_match(const Problem &problem) {
  std::vector<Integer> settled;
  for (const ProblemClass &c : problem.classes())
    settled.push_back(std::max(c.floor, settled_count(c, problem.scale_power())));
  const Problem above = problem.from_scale(problem.lowest_scale(settled), true);
  std::vector<Integer> q;
  for (const ProblemClass &c : above.classes())
    q.push_back(c.floor);
  return q;
}

} // namespace mdm
