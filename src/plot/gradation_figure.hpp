#pragma once
/// \file
/// The figure of a gradation as the field draws it, and of a set of particles that matches it.

#include "plot/figure.hpp"
#include "plot/figure_form.hpp"
#include "soil/describe.hpp"

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// The classification whose size bands are shown.
enum class Bands { uscs, iso_14688, none };

/// The series of sieves after which openings are named: ASTM E11 (`No. 200`); ISO 3310-1 (`0.075`), by its
/// opening; or none of the openings.
enum class SieveNames { astm, iso, none };

/// The particles of one class, lower < size <= upper; lengths in the gradation's unit.
struct DrawnClass {
  Rational lower, upper;
  Rational mass;
  Integer quantity; ///< 1 or more
  Rational size;    ///< within what the drawing can show
};

/// Particles of one size, in the gradation's unit.
struct DrawnSize {
  Rational size, mass;
};

/// The contents of a figure. \invariant curve or counts; counts only of particles
struct GradationFigure {
  Bands bands = Bands::uscs;
  bool of_particles = false; ///< the curve is that of particles, not of sieves
  SieveNames sieve_names = SieveNames::iso;
  DescribeOptions soil; ///< for the index numbers and the group
  bool coarse_left = false;
  bool curve = true;                 ///< percent passing over size
  bool counts = false;               ///< particles of each class over size
  std::optional<Envelope> envelope;  ///< of the curve
  std::vector<DrawnClass> particles; ///< ascending; empty: none to show
  std::vector<DrawnSize> sizes;      ///< of the particles, ascending; empty: one a class
  Integer outside = 0;               ///< particles outside all classes, which `sizes` have alone
  FigureForm form;
};

/// The gradation's curve through its sieves over log size, percent passing and retained; D10, D30, D60, C_u,
/// C_c and the group, with what reading the file and these numbers assume; against it the set of particles as
/// the steps of what passes, and their counts. Below the finest sieve above a pan at 0 the curve is not
/// known: a dashed line shows how much passes it. In a narrow picture the right side is left free.
Figure gradation_figure(const Gradation &g, const GradationFigure &what);

} // namespace mdm
