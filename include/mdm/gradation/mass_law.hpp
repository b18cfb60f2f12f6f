#pragma once
/// \file
/// The law from size to mass.

#include <mdm/gradation/size_unit.hpp>

#include <string>
#include <vector>

namespace mdm {

/// The mass of a particle of one size, in a law by table.
struct LawNode {
  Rational size, mass; ///< > 0
  bool operator==(const LawNode &) const = default;
};

/// coefficient * x^exponent, in a law by sum.
struct LawTerm {
  Rational coefficient;  ///< > 0
  unsigned exponent = 1; ///< >= 1
  bool operator==(const LawTerm &) const = default;
};

/// f, continuous and strictly increasing with f(0) = 0: the mass of a particle of size x up to a constant
/// that cancels (Arnold, Eq. 14; x^3 for spheres). It is x^(a/b) with a/b > 0 in lowest terms; or linear
/// between the nodes of a table, from (0, 0) to the last one; or a sum of powers. Since x^(a/b) may be
/// irrational, values are handled to the power b. A law by table or sum has a = b = 1: its values take the
/// place of sizes under x^1 (Theorem 24), and it holds for sizes in one unit, that of the gradation.
struct MassLaw {
  unsigned a = 3;
  unsigned b = 1;
  std::vector<LawNode> table = {}; ///< sizes and masses ascending, without (0, 0)
  std::vector<LawTerm> sum = {};   ///< exponents descending

  /// True if it is x^(a/b).
  bool is_power() const { return table.empty() && sum.empty(); }
  /// True for the sphere, x^3.
  bool is_sphere() const { return a == 3 && b == 1; }
  /// f(x)^b for x >= 0.
  /// \throws InputError if x is beyond the last node of the table
  Rational powered(const Rational &x) const;
  /// `a` or `a/b`. \pre is_power()
  std::string exponent() const;
  /// `x^(5/2)`, `2*x^3 + 1/3*x, x in mm` or `by the table 0.5 mm: 1, 2 mm: 70`. \param unit  of the sizes
  std::string formula(SizeUnit unit) const;
  /// The law that gives a size times `factor` the mass of that size: the same law in another unit. A power is
  /// itself, as a constant is nothing to it.
  MassLaw scaled(const Rational &factor) const;
  /// At least the relative change of f(x) over that of x, for small changes.
  Rational steepness() const;

  bool operator==(const MassLaw &) const = default;
};

/// The largest a and b, and the largest exponent of a sum.
inline constexpr unsigned max_law_exponent = 1000;
/// The most terms of a sum.
inline constexpr std::size_t max_law_terms = 16;
/// The most nodes of a table.
inline constexpr std::size_t max_law_nodes = 1000;

/// Reads `sphere`, `power:a`, `power:a/b` or `sum:c*x^n+c*x^n`, the last one of x in mm.
/// \throws InputError for anything else
MassLaw parse_mass_law(std::string_view text);

/// Reads a law by table from CSV with the header `size_mm,particle_mass`. \param source  the file's name
/// \throws InputError with the line of what is wrong
MassLaw read_law_table(std::string_view csv, const std::string &source);

} // namespace mdm
