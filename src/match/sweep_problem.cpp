// The problem as the sweep needs it: integers of 128 bits, if all fit, or of any length, and beside them
// the doubles f / m and m / F. Ranges are cut so that no product of doubles overflows or loses digits; what
// is outside of them is NaN, with which every comparison is false, and false leads to the exact decision
// (Lemma 11). settled_count is the least count from which on a class raises no more (Theorem 3 (c)).

#include "match/sweep_problem.hpp"

#include <cmath>
#include <limits>

namespace mdm {
namespace {

constexpr double not_certain = std::numeric_limits<double>::quiet_NaN();

bool in_safe_range(double x) {
  return x >= 0x1p-200 && x <= 0x1p200;
}

/// settled_count, in Int where the class is wide.
template <class Int>
Int settled(const SweepClass<Int> &c, const ProblemClass &given, unsigned b) {
  return c.F >= power(Int(2), b) * c.f ? Int(1) : Int(settled_count(given, b));
}

} // namespace

Integer settled_count(const ProblemClass &c, unsigned b) {
  if (c.F >= (c.f << b))
    return 1;
  if (b == 1)
    return ceil_div(c.f, c.F - c.f);
  const auto settled = [&](const Integer &n) { return power(n, b) * c.F >= power(Integer(n + 1), b) * c.f; };
  Integer high = 2;
  while (!settled(high))
    high *= 2;
  Integer low = high / 2; // not settled
  while (high - low > 1) {
    const Integer middle = (low + high) / 2;
    (settled(middle) ? high : low) = middle;
  }
  return high;
}

double to_double(const Integer &n) {
  return mpz_size(n.backend().data()) <= 7 || bit_length(n) <= 500 ? mpz_get_d(n.backend().data())
                                                                   : not_certain;
}

template <class Int>
SweepProblem<Int>::SweepProblem(const Problem &problem) : b(problem.scale_power()) {
  classes.reserve(problem.classes().size());
  for (const ProblemClass &given : problem.classes()) {
    SweepClass<Int> c{Int(given.f), Int(given.F), Int(given.mass), Int(given.floor), 1, 0, 0, 0};
    c.settled = settled(c, given, b);
    c.floor_approx = to_double(c.floor);
    c.lower = to_double(c.f) / to_double(c.mass);
    c.per_upper = to_double(c.mass) / to_double(c.F);
    if (b > 1 || (c.lower != 0 && !in_safe_range(c.lower)) || !in_safe_range(c.per_upper))
      c.lower = c.per_upper = not_certain;
    classes.push_back(std::move(c));
  }
}

template struct SweepProblem<Int128>;
template struct SweepProblem<Integer>;

} // namespace mdm
