#pragma once
/// \file
/// The law from size to mass.

#include <mdm/number/rational.hpp>

namespace mdm {

/// f(x) = x^(a/b) with a/b > 0 in lowest terms: the mass of a particle of size x up to a constant that
/// cancels (Arnold, Eq. 14; x^3 for spheres). Since f may be irrational, values are handled to the power b:
/// f(x)^b = x^a.
struct MassLaw {
  unsigned a = 3;
  unsigned b = 1;

  /// f(x)^b = x^a.
  Rational powered(const Rational &x) const { return power(x, a); }
  /// True for the sphere, x^3.
  bool is_sphere() const { return a == 3 && b == 1; }
  /// `a` or `a/b`.
  std::string exponent() const;

  bool operator==(const MassLaw &) const = default;
};

/// The largest a and b.
inline constexpr unsigned max_law_exponent = 1000;

/// Reads `sphere`, `power:a` or `power:a/b`.
/// \throws InputError for anything else
MassLaw parse_mass_law(std::string_view text);

} // namespace mdm
