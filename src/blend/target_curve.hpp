#pragma once
/// \file
/// Grading curves that are computed: the lines that asphalt and concrete are aimed at.

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>

#include <string_view>

namespace mdm {

/// Decimals of the percents of a computed curve.
constexpr unsigned target_places = 9;

/// What passes the size d is a + (100 - a) (d^q - l^q) / (D^q - l^q) percent between l and D; nothing passes
/// up to l > 0, all passes from D on. Sizes in mm.
struct TargetCurve {
  Rational largest;      ///< D > l
  Rational smallest = 0; ///< l >= 0
  Rational exponent;     ///< q > 0
  Rational start = 0;    ///< a percent, at least 0, less than 100; 0 where l > 0

  /// Percent of what passes a size > 0, rounded to target_places, halves up. Cost: some roots.
  Rational passing(const Rational &size) const;
};

/// True for a text that names such a curve: a word and a colon.
bool names_target_curve(std::string_view text);

/// Reads
/// `power45:D`, q = 0.45 and l = a = 0, the maximum density line of Superpave;
/// `fuller:D`, q = 1/2 (Fuller and Thompson 1907);
/// `andreasen:D,q=Q,dmin=L`, dmin 0 where it is left out (Andreasen and Andersen 1930; Funk and Dinger 1980);
/// `bolomey:D,a=A`, q = 1/2 (Bolomey 1935). Sizes are in mm or have a unit.
/// \throws InputError where the text is none of them
TargetCurve parse_target_curve(std::string_view text);

/// The curve at the sieves of a specification and at D, with a note of what it is. \param name  its id
Gradation gradation_of(const TargetCurve &curve, const Envelope &specification, const std::string &name);

} // namespace mdm
