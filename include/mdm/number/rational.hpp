#pragma once
/// \file
/// Exact fractions.

#include <mdm/number/integer.hpp>

namespace mdm {

/// A fraction in lowest terms with positive denominator. Expression templates are off, as for Integer.
using Rational =
    boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off>;

/// n / d in lowest terms, for d != 0.
Rational ratio(const Integer &n, const Integer &d);

/// Largest integer <= r. (A cast would go through double in Boost 1.74.)
Integer floor(const Rational &r);

/// Least integer >= r.
Integer ceil(const Rational &r);

/// base^exponent.
Rational power(const Rational &base, unsigned exponent);

/// The y >= 0 with y^degree = r, for r >= 0, if it is a fraction.
std::optional<Rational> exact_root(const Rational &r, unsigned degree);

/// The fraction of least denominator (and then of least numerator) in [lo, hi], for 0 < lo <= hi.
/// Cost: a continued fraction, linear in the digits of the result.
Rational simplest_between(const Rational &lo, const Rational &hi);
/// The simplest fraction in [lo/unit, hi/unit].
Rational simplest_between(const Integer &lo, const Integer &hi, const Integer &unit);

/// `p/q` in lowest terms, or `p` for an integer.
std::string to_string(const Rational &r);

} // namespace mdm
