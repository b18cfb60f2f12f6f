// Fractions beyond what Boost has. floor and ceil divide integers, since a cast would go through double;
// exact_root takes the roots of numerator and denominator, which are powers if the fraction in lowest terms
// is. simplest_between walks down the continued fractions of both ends while they agree: where they part,
// the least integer between is the last digit of the fraction with the least denominator. It ends as
// Euclid's algorithm does.

#include "number/words.hpp"

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

namespace {

/// simplest_between [n/d, m/e]. Int is Integer or, for less than 2^62, std::int64_t.
template <class Int>
Rational simplest(Int n, Int d, Int m, Int e) {
  // While no integer lies in the interval, both ends have the same integer part t: it is subtracted and the
  // rest inverted, which exchanges the ends. (p1, q1) and (p0, q0) are the last convergents of these t. None
  // is above the numerator and the denominator of n/d, which lies in the interval too.
  Int p0 = 0, q0 = 1, p1 = 1, q1 = 0;
  for (;;) {
    Int t = n / d;
    n -= t * d;
    const bool inside = n == 0 || (t + 1) * e <= m;
    if (inside && n != 0)
      ++t;
    p0 += t * p1;
    q0 += t * q1;
    std::swap(p0, p1);
    std::swap(q0, q1);
    if (inside)
      return ratio(p1, q1);
    m -= t * e;
    // New interval [e / m, d / n].
    std::swap(m, d);
    std::swap(n, e);
  }
}

Rational simplest_of_parts(const Integer &n, const Integer &d, const Integer &m, const Integer &e) {
  const auto is_short = [](const Integer &part) { return bit_length(part) <= 62; };
  const auto short_part = [](const Integer &part) { return static_cast<std::int64_t>(word(part, 0)); };
  if (is_short(n) && is_short(d) && is_short(m) && is_short(e))
    return simplest(short_part(n), short_part(d), short_part(m), short_part(e));
  return simplest(n, d, m, e);
}

} // namespace

Rational simplest_between(const Rational &lo, const Rational &hi) {
  return simplest_of_parts(numerator(lo), denominator(lo), numerator(hi), denominator(hi));
}

Rational simplest_between(const Integer &lo, const Integer &hi, const Integer &unit) {
  return simplest_of_parts(lo, unit, hi, unit);
}

std::string to_string(const Rational &r) {
  std::string text = to_string(Integer(numerator(r)));
  if (const Integer d = denominator(r); d != 1)
    text.append(1, '/').append(to_string(d));
  return text;
}

} // namespace mdm
