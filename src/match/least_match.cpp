#include <mdm/match/least_match.hpp>

#include <cmath>

namespace mdm {
namespace {

/// Relative error bound of the doubles below: a level is off by at most 8u, a quotient by at most 14u (lower 5u, count
/// 2u, per_upper 5u, an operation u each) plus terms in u^2; 2^-49 = 16u. A difference of two levels is decided if it
/// is more than 2^-48 of them.
constexpr double quotient_error = 0x1p-49;
constexpr double level_error = 0x1p-48;

/// Below this a double holds every integer, and y - floor(y) is computed exactly.
constexpr double largest_quotient = 0x1p50;

/// The lower bound L on the scale and what every class needs above it.
template <class Int>
class Sweep {
public:
  Sweep(const SweepProblem<Int> &problem, const Limits &limits) : problem_(problem), limits_(limits) {}

  LeastMatch run() {
    LeastMatch result;
    result.complete = start(result.chain) && rounds(result.chain);
    result.q.reserve(problem_.classes.size());
    for (const SweepClass<Int> &c : problem_.classes)
      result.q.push_back(to_integer(count(c)));
    return result;
  }

private:
  using Class = SweepClass<Int>;

  static Integer to_integer(const Integer &n) { return n; }
  static Integer to_integer(Int128 n) { return n.to_integer(); }

  /// n^b f / mass.
  struct Level {
    Int product = 0;
    Int mass = 1;
    double approx = 0;
  };

  /// The largest integer q with q^b F / mass <= L.
  Int count_below(const Class &c) const {
    const double y = level_.approx * c.per_upper;
    if (y < largest_quotient) {
      const double t = std::floor(y);
      const double slack = y * quotient_error;
      if (y - t > slack && t + 1 - y > slack)
        return Int(static_cast<std::int64_t>(t));
    }
    return floor_root(floor_div(level_.product * c.mass, level_.mass * c.F), problem_.b);
  }

  /// Least count that class c needs at scales above L.
  Int count(const Class &c) const {
    Int n = count_below(c) + Int(1);
    return n < c.floor ? c.floor : n;
  }

  /// Raises L to n^b f / mass if that is more.
  bool raise(const Class &c, const Int &n) {
    const double approx = to_double(n) * c.lower;
    if (approx < level_.approx * (1 - level_error))
      return false;
    Int product = power(n, problem_.b) * c.f;
    if (!(approx > level_.approx * (1 + level_error)) && product * level_.mass <= level_.product * c.mass)
      return false;
    level_ = Level{std::move(product), c.mass, approx};
    return true;
  }

  /// True if a count above n could raise L: the smallest, n + 1, has (n + 1)^b f > n^b F.
  bool may_move(const Class &c, const Int &n) const {
    return power(n, problem_.b) * c.F < power(n + Int(1), problem_.b) * c.f;
  }

  bool interrupted(const Chain &chain) {
    if (limits_.max_steps && chain.size() >= *limits_.max_steps)
      return true;
    constexpr std::uint64_t between_looks = 1024;
    return limits_.deadline && ++looks_ % between_looks == 0 && std::chrono::steady_clock::now() > *limits_.deadline;
  }

  /// First step: the largest level of the floors.
  bool start(Chain &chain) {
    std::uint32_t highest = 0;
    for (std::uint32_t j = 0; j < problem_.classes.size(); ++j) {
      const Class &c = problem_.classes[j];
      if (raise(c, c.floor))
        highest = j;
      if (may_move(c, c.floor))
        movable_.push_back(j);
    }
    if (level_.product == Int(0))
      return true;
    if (interrupted(chain)) {
      level_ = Level{};
      return false;
    }
    chain.push_back(highest);
    return true;
  }

  /// Rounds over the movable classes until none raises L. False if interrupted.
  bool rounds(Chain &chain) {
    for (bool moved = true; moved;) {
      moved = false;
      std::size_t kept = 0;
      for (std::size_t i = 0; i < movable_.size(); ++i) {
        const std::uint32_t j = movable_[i];
        const Class &c = problem_.classes[j];
        const Int n = count(c);
        const Level before = level_;
        if (raise(c, n)) {
          if (interrupted(chain)) {
            level_ = before;
            return false;
          }
          chain.push_back(j);
          moved = true;
        }
        if (may_move(c, n))
          movable_[kept++] = j;
      }
      movable_.resize(kept);
    }
    return true;
  }

  const SweepProblem<Int> &problem_;
  const Limits &limits_;
  Level level_;
  std::vector<std::uint32_t> movable_;
  std::uint64_t looks_ = 0;
};

/// Least count n with n^b F >= (n + 1)^b f: from then on the class cannot move.
Integer settled_count(const ProblemClass &c, unsigned b) {
  const auto settled = [&](const Integer &n) { return power(n, b) * c.F >= power(Integer(n + 1), b) * c.f; };
  Integer high = 1;
  while (!settled(high))
    high *= 2;
  Integer low = high / 2; // not settled, or 0
  while (high - low > 1) {
    const Integer middle = (low + high) / 2;
    (settled(middle) ? high : low) = middle;
  }
  return high;
}

} // namespace

template <class Int>
LeastMatch least_match(const SweepProblem<Int> &problem, const Limits &limits) {
  return Sweep<Int>(problem, limits).run();
}

template LeastMatch least_match(const SweepProblem<Int128> &, const Limits &);
template LeastMatch least_match(const SweepProblem<Integer> &, const Limits &);

LeastMatch least_match(const Problem &problem, const Limits &limits) {
  try {
    return least_match(SweepProblem<Int128>(problem), limits);
  } catch (const Int128Overflow &) {
    return least_match(SweepProblem<Integer>(problem), limits);
  }
}

std::vector<Integer> some_match(const Problem &problem) {
  std::vector<Integer> settled;
  for (const ProblemClass &c : problem.classes())
    settled.push_back(std::max(c.floor, settled_count(c, problem.law().b)));
  const Problem above = problem.from_scale(problem.lowest_scale(settled), true);
  std::vector<Integer> q;
  for (const ProblemClass &c : above.classes())
    q.push_back(c.floor);
  return q;
}

} // namespace mdm
