#include <mdm/match/sweep_problem.hpp>

#include <cmath>
#include <limits>

namespace mdm {
namespace {

constexpr double not_certain = std::numeric_limits<double>::quiet_NaN();

bool in_safe_range(double x) { return x >= 0x1p-200 && x <= 0x1p200; }

template <class Int>
void approximate(SweepClass<Int> &c) {
  c.lower = to_double(c.f) / to_double(c.mass);
  c.per_upper = to_double(c.mass) / to_double(c.F);
  if ((c.lower != 0 && !in_safe_range(c.lower)) || !in_safe_range(c.per_upper))
    c.lower = c.per_upper = not_certain;
}

} // namespace

double to_double(const Integer &n) {
  return bit_length(n) <= 500 ? mpz_get_d(n.backend().data()) : not_certain;
}

template <class Int>
SweepProblem<Int>::SweepProblem(const Problem &problem) : b(problem.law().b) {
  classes.reserve(problem.classes().size());
  for (const ProblemClass &c : problem.classes()) {
    classes.push_back({Int(c.f), Int(c.F), Int(c.mass), Int(c.floor)});
    if (b == 1)
      approximate(classes.back());
    else
      classes.back().lower = classes.back().per_upper = not_certain;
  }
}

template struct SweepProblem<Int128>;
template struct SweepProblem<Integer>;

} // namespace mdm
