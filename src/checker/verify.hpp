#pragma once

#include "certificate.hpp"
#include "gradation.hpp"
#include "text.hpp"

namespace mdm::checker {

/// A certificate that is well formed, and does not prove its claim.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Verifies the claim of an exact match, by a chain (sections 2 and 3). Throws Refused at the first thing
/// that fails, Malformed where it would take too long.
void verify_exact(Gradation gradation, const Certificate &certificate);

/// The same for a match within a tolerance, by a tree (section 6).
void verify_tolerant(Gradation gradation, const Certificate &certificate);

// Functions that both share.

/// Refuses the certificate where a condition does not hold, in class j (from 1) if that is given.
void demand(bool holds, const char *condition, std::uint64_t j = 0);

/// Malformed where the work is more than a limit of section 2: 2^`most`.
void demand_within(std::uint64_t work, unsigned most, const Certificate &certificate);

/// Operations that n openings, the limits of a band and the steps of a chain, or the nodes and multiples of a
/// tree take, for limits 2 and 6.
std::uint64_t work_of(const Gradation &gradation, const Certificate &certificate, std::uint64_t n);
/// A length of the question to the power d of the openings; limit 1.
mpq_class to_power(const mpq_class &length, unsigned long d, const Certificate &certificate);

/// A fraction that need not be in lowest terms, so that no loop pays for a gcd.
struct Ratio {
  mpz_class num, den;
  Ratio(mpz_class n = 0, mpz_class d = 1) : num(std::move(n)), den(std::move(d)) {}
  Ratio(const mpq_class &value) : num(value.get_num()), den(value.get_den()) {}

  friend Ratio operator*(const Ratio &x, const Ratio &y) { return {x.num * y.num, x.den * y.den}; }
  friend Ratio operator*(const Ratio &x, const mpz_class &n) { return {x.num * n, x.den}; }
  friend Ratio operator/(const Ratio &x, const Ratio &y) { return {x.num * y.den, x.den * y.num}; }
  friend int compare(const Ratio &x, const Ratio &y) { return cmp(x.num * y.den, y.num * x.den); }
};
inline Ratio power(const Ratio &x, unsigned long exponent) {
  return {power(x.num, exponent), power(x.den, exponent)};
}

mpz_class common_denominator(const Rationals &values);
/// value * unit, an integer.
mpz_class in_units(const mpq_class &value, const mpz_class &unit);
/// Multiplies `common` until it is a multiple of the divisor; limit 4.
void include(mpz_class &common, const mpz_class &divisor, const Certificate &certificate);
/// The number of the line; 0 where it is absent.
mpz_class integer_of(const Numbers &line);

/// The root of a degree where it is rational.
std::optional<mpq_class> rational_root(const mpq_class &value, unsigned long degree);

/// Applies pan-size, cut-below and size-factor, in this order, and demands the limits 1 and 2.
void apply_question(Gradation &gradation, const Certificate &certificate);

/// 6 V / pi, or bounds: every sample with the volume has more than `below`, and `enough` is enough. 0
/// without solids.
struct Solids {
  mpq_class below, enough;
};
Solids solids(const Certificate &certificate);

/// The bounds on the share of a class that a tolerance's lines make, retained and passing, cut at 0 and 1.
struct BoundsOnShares {
  mpq_class least_retained, most_retained, least_passing, most_passing;
};
std::vector<BoundsOnShares> bounds_on_shares(const Gradation &gradation, const Certificate &certificate);

/// p < pi < r.
void verify_pi(const Certificate &certificate);

/// The size of class j, (x_j, x_{j+1}] between the openings, is in [lo, hi]. It is the root of T of a degree,
/// or under a law by table or sum that with f(x) = T.
void verify_size(const Gradation &gradation, const Certificate &certificate, const ClassWitness &witness,
                 const Ratio &T, unsigned long degree);

} // namespace mdm::checker
