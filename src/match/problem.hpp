#pragma once
/// \file
/// The integer problem behind a match.

#include <mdm/match/question.hpp>

namespace mdm {

/// Bits of powers; longer ones are refused. The checker has the same limit (certificate-format.md, section
/// 2).
inline constexpr std::size_t max_power_bits = std::size_t{1} << 20;

/// The values of a law by table or sum at the openings of g, which take their place under x^1 (Theorem 24).
/// \pre !law.is_power()
/// \throws InputError if an opening is irrational or beyond the table
std::vector<Rational> values_at_openings(const Gradation &g, const MassLaw &law);

/// One class with mass, in integers. With the law x^(a/b) and openings that are d-th roots of fractions, q
/// particles can hold the mass s m iff q^p f < S mass <= q^p F, p = b d, where S is s^p times a constant of
/// the problem (Theorem 1, to the power p).
struct ProblemClass {
  std::size_t index = 0; ///< class of the gradation, from 0
  Integer f;             ///< c^p x_j^(a d) >= 0, denominators cleared
  Integer F;             ///< c^p x_{j+1}^(a d) > f, denominators cleared
  Integer mass;          ///< m_j^p > 0, denominators cleared
  Integer floor;         ///< r_j >= 1, the least count that is allowed
};

/// Minimise sum q_j over integers q_j >= r_j and scales S > 0 with q_j^p f_j < S m_j <= q_j^p F_j in every
/// class with mass ((*) of proofs/README.md). Classes are ascending; there is at least one. Common
/// denominators are cleared once: S is the gradation's s^p divided by scale_unit().
class Problem {
public:
  /// The problem of a gradation (with the question's changes already made), every floor `min_per_class` or 1.
  /// \throws InputError if powers of its numbers get out of hand (more than max_power_bits)
  Problem(const Gradation &g, const MassLaw &law, const Integer &min_per_class);

  const std::vector<ProblemClass> &classes() const { return classes_; }
  const MassLaw &law() const { return law_; }
  /// d of the gradation.
  unsigned root() const { return root_; }
  /// p = b d: scales are to this power.
  unsigned scale_power() const { return law_.b * root_; }
  /// s^p / S.
  const Rational &scale_unit() const { return scale_unit_; }
  /// sum m_j / c_j over the classes: the volume of the sample over s, times 6 / pi for spheres.
  const Rational &weight() const { return weight_; }

  /// The same problem at scales S >= start (closed) or S > start (open): nothing but higher floors (Theorem
  /// 6).
  Problem from_scale(const Rational &start, bool open) const;
  /// The same problem with the floor of class j at `least` or higher.
  Problem with_floor(std::size_t j, const Integer &least) const;

  /// Lowest scale, exclusive, and highest, inclusive, at which q is a match: max q^p f / m and min q^p F / m.
  /// q is a match iff the first is below the second.
  Rational lowest_scale(const std::vector<Integer> &q) const;
  Rational highest_scale(const std::vector<Integer> &q) const;

private:
  void multiply(const std::vector<Rational> &by);
  bool holds_invariant() const;

  MassLaw law_;
  unsigned root_;
  Rational scale_unit_;
  Rational weight_;
  std::vector<ProblemClass> classes_;
};

/// Sum of quantities.
Integer total(const std::vector<Integer> &q);

} // namespace mdm
