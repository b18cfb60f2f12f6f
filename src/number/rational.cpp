#include <mdm/number/rational.hpp>

namespace mdm {

Rational ratio(const Integer &n, const Integer &d) {
  Rational r;
  mpz_set(mpq_numref(r.backend().data()), n.backend().data());
  mpz_set(mpq_denref(r.backend().data()), d.backend().data());
  mpq_canonicalize(r.backend().data());
  return r;
}

Integer floor(const Rational &r) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(), mpq_numref(r.backend().data()), mpq_denref(r.backend().data()));
  return quotient;
}

Integer ceil(const Rational &r) {
  Integer quotient;
  mpz_cdiv_q(quotient.backend().data(), mpq_numref(r.backend().data()), mpq_denref(r.backend().data()));
  return quotient;
}

Rational power(const Rational &base, unsigned exponent) {
  // Powers of coprime numbers are coprime: no reduction is needed.
  Rational r;
  mpz_pow_ui(mpq_numref(r.backend().data()), mpq_numref(base.backend().data()), exponent);
  mpz_pow_ui(mpq_denref(r.backend().data()), mpq_denref(base.backend().data()), exponent);
  return r;
}

std::optional<Rational> exact_root(const Rational &r, unsigned degree) {
  // A fraction in lowest terms is a power iff both its parts are; their roots are coprime too.
  Rational root;
  const bool exact = mpz_root(mpq_denref(root.backend().data()), mpq_denref(r.backend().data()), degree) != 0 &&
                     mpz_root(mpq_numref(root.backend().data()), mpq_numref(r.backend().data()), degree) != 0;
  return exact ? std::optional(root) : std::nullopt;
}

Rational simplest_between(const Rational &lo, const Rational &hi) {
  // The continued fractions of lo and hi agree until an integer (or hi's own end) lies in the remaining interval.
  // [lo, hi] = [n/d, m/e]; the convergents (p, q) of the common part are kept.
  Integer n = numerator(lo), d = denominator(lo), m = numerator(hi), e = denominator(hi);
  Integer p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  for (;;) {
    const Integer least = ceil_div(n, d);
    const bool integer_inside = least * e <= m;
    const Integer term = integer_inside ? least : Integer(least - 1);
    Integer p2 = term * p1 + p0;
    Integer q2 = term * q1 + q0;
    if (integer_inside)
      return ratio(p2, q2);
    p0 = std::move(p1), q0 = std::move(q1), p1 = std::move(p2), q1 = std::move(q2);
    // Both ends lie strictly between term and term + 1: invert the fractional parts, which exchanges the ends.
    Integer low_part = n - term * d;
    Integer high_part = m - term * e;
    n = std::move(e), m = std::move(d);
    d = std::move(high_part), e = std::move(low_part);
  }
}

std::string to_string(const Rational &r) {
  const Integer d = denominator(r);
  const std::string n = to_string(Integer(numerator(r)));
  return d == 1 ? n : n + "/" + to_string(d);
}

} // namespace mdm
