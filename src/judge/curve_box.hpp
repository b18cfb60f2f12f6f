#pragma once
/// \file
/// All grading curves that round to one report.

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/interval.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// The curves through P_0 <= ... <= P_n, the percents that pass x_0 < ... < x_n, with P_i in passing[i] and
/// P_{i+1} - P_i in retained[i]; between two sieves above 0 they are linear in log size. x_0 = 0 mm and P_0 =
/// 0; P_n = 100, because the largest sieve of a gradation retains nothing. Such sets of curves have a least
/// and a greatest one, which pass the least and the most everywhere.
struct CurveBox {
  std::vector<RootSize> openings; ///< mm
  std::vector<Rational> reported; ///< the curve of the report itself
  std::vector<Interval> passing;
  std::vector<Interval> retained; ///< of class i, between x_i and x_{i+1}
  bool is_exact = true;           ///< nothing was rounded

  /// Makes `passing` as narrow as the curves of the box are: its lower ends are the least curve, its upper
  /// ends the greatest. False if there is no curve.
  bool narrow();
  /// The percents of the least and of the greatest curve. \pre narrow() was called
  std::vector<Rational> least_curve() const;
  std::vector<Rational> greatest_curve() const;
  /// Adds `size` (mm), which lies between 0 and x_1, as a sieve of which nothing is reported.
  void add_unmeasured(const Rational &size);
};

/// The box of a report. Every percent, of what passes or is retained as the report has it, stands for the
/// numbers that round to it: within half a unit of its last digit, from 0 to 100. Of masses nothing was
/// rounded.
/// \param unit  of the last digit of all percents (of masses, of what passes); 0: nothing was rounded
/// \throws InputError if percents retained cannot be those of a whole
CurveBox curves_of(const UnderstoodGradation &report, const std::optional<Rational> &unit);

} // namespace mdm
