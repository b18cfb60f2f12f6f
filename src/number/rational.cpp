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
  const bool exact =
      mpz_root(mpq_denref(root.backend().data()), mpq_denref(r.backend().data()), degree) != 0 &&
      mpz_root(mpq_numref(root.backend().data()), mpq_numref(r.backend().data()), degree) != 0;
  return exact ? std::optional(root) : std::nullopt;
}

Rational simplest_between(const Rational &lo, const Rational &hi) {
  // [n/d, m/e] = [lo, hi]. While no integer lies in it, both ends have the same integer part t: it is
  // subtracted and the rest inverted, which exchanges the ends. (p1, q1) and (p0, q0) are the last
  // convergents of these t.
  Integer n = numerator(lo), d = denominator(lo), m = numerator(hi), e = denominator(hi);
  Integer p0 = 0, q0 = 1, p1 = 1, q1 = 0, t, rest;
  const auto extend = [&t](Integer &before, Integer &last) {
    mpz_addmul(before.backend().data(), t.backend().data(), last.backend().data());
    before.swap(last);
  };
  for (;;) {
    // n becomes n - t d <= 0 with t = ceil(n / d): t is the least integer from n/d on.
    mpz_cdiv_qr(t.backend().data(), n.backend().data(), n.backend().data(), d.backend().data());
    mpz_set(rest.backend().data(), m.backend().data());
    mpz_submul(rest.backend().data(), t.backend().data(), e.backend().data());
    const bool inside = rest >= 0;
    if (!inside) { // take floor(n / d) = t - 1 instead
      --t;
      n += d;
      rest += e;
    }
    extend(p0, p1);
    extend(q0, q1);
    if (inside)
      return ratio(p1, q1);
    // New interval [e / rest, d / n].
    m.swap(d);
    d.swap(rest);
    e.swap(n);
  }
}

std::string to_string(const Rational &r) {
  const Integer d = denominator(r);
  const std::string n = to_string(Integer(numerator(r)));
  return d == 1 ? n : n + "/" + to_string(d);
}

} // namespace mdm
