#include <mdm/match/cleared_problem.hpp>

#include <cmath>
#include <limits>

namespace mdm {
namespace {

constexpr double not_certain = std::numeric_limits<double>::quiet_NaN();

Integer common_denominator(const std::vector<ProblemClass> &classes, Rational ProblemClass::*member) {
  Integer common = 1;
  for (const ProblemClass &c : classes)
    mpz_lcm(common.backend().data(), common.backend().data(), mpq_denref((c.*member).backend().data()));
  return common;
}

/// r * common, an integer.
Integer cleared(const Rational &r, const Integer &common) {
  Integer n;
  mpz_divexact(n.backend().data(), common.backend().data(), mpq_denref(r.backend().data()));
  mpz_mul(n.backend().data(), n.backend().data(), mpq_numref(r.backend().data()));
  return n;
}

bool in_safe_range(double x) { return x >= 0x1p-200 && x <= 0x1p200; }

template <class Int>
void approximate(ClearedClass<Int> &c) {
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
ClearedProblem<Int>::ClearedProblem(const Problem &problem) : b(problem.law().b) {
  const std::vector<ProblemClass> &given = problem.classes();
  Integer of_f = common_denominator(given, &ProblemClass::f);
  const Integer of_F = common_denominator(given, &ProblemClass::F);
  mpz_lcm(of_f.backend().data(), of_f.backend().data(), of_F.backend().data());
  const Integer of_mass = common_denominator(given, &ProblemClass::mass);
  classes.reserve(given.size());
  for (const ProblemClass &c : given) {
    classes.push_back({Int(cleared(c.f, of_f)), Int(cleared(c.F, of_f)), Int(cleared(c.mass, of_mass)), Int(c.floor)});
    if (b == 1)
      approximate(classes.back());
    else
      classes.back().lower = classes.back().per_upper = not_certain;
  }
}

template struct ClearedProblem<Int128>;
template struct ClearedProblem<Integer>;

} // namespace mdm
