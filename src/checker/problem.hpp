#pragma once

#include "certificate.hpp"
#include "gradation.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <string>
#include <vector>

namespace mdm_check {

/// A certificate that is well formed, and does not prove its claim.
struct Refused : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A fraction without sign, not in lowest terms, so that no loop pays for a gcd.
struct Ratio {
  mpz_class numerator, denominator;
};

/// One class in integers: A_j = u f / M and B_j = u F / M with the problem's scale unit u.
struct Class {
  bool has_mass;
  mpz_class f, F, M;
  mpz_class C;     ///< the factor to the power b, in its own unit
  mpz_class floor; ///< r_j: no match has fewer particles in the class
};

/// The problem of section 2. All scales are to the power b, and divided by the scale unit.
struct Problem {
  unsigned long a, b;
  std::vector<mpq_class> openings;
  mpz_class opening_unit; ///< the openings times this are integers
  std::vector<Class> classes;
  Ratio scale;       ///< the witness's
  Ratio least_scale; ///< 0, or what the solids demand of the witness
  Ratio above;       ///< z, or 0
};

/// Derives the problem; what does not fit together is Refused, what would take too long is Malformed.
Problem derive(Gradation gradation, const Certificate &certificate);

/// The least count q >= r_j with q^b B_j > L (Theorem 1).
mpz_class count(const Class &class_j, const Ratio &L, unsigned long b);

mpz_class integer_root(const mpz_class &value, unsigned long degree);

} // namespace mdm_check
