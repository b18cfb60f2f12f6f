#pragma once
/// \file
/// The contents of the figures of Voivret, Delenne and Radjai, "Models of particle size distribution", of the
/// cumulative beta model and the sets made from it. Discs (dimension 2), as in the paper.

#include "sets/beta_curve.hpp"
#include "sets/class_counts.hpp"
#include "sets/set_quality.hpp"

namespace mdm {

/// a and b of the model.
struct Shape {
  Rational a, b;
};

/// The curve of the shape from d_min = 1 on with the span s (Eq. 17), 0 < s < 1.
BetaCurve spanned_curve(const Shape &shape, const Rational &span);

/// The four functions that describe a set by number and by volume (Eq. 5), sizes in mm: Figure 1.
struct DistributionRow {
  Rational size;
  Real number_density, volume_density; ///< f and V, per mm
  Real partition, grading;             ///< F and h
};
/// From 0.001 to 0.01 mm, with the shape (3, 3): the middles of 100 regular classes, each uniform by volume.
std::vector<DistributionRow> figure1_rows();

/// h of a shape at the reduced diameter d_r (Eq. 15-16): Figure 3.
struct PassingRow {
  Shape shape;
  Rational reduced;
  Real passing;
};
/// Curves of the kinds that the paper's section 2.1 names, at 201 d_r, which are densest near 0 and 1, where
/// curves may be steep: d_r = t^3 (10 - 15 t + 6 t^2) for t = 0, 1/200, ..., 1.
std::vector<PassingRow> figure3_rows();

/// The shapes that the paper's section 2.2 compares: (1, 3), (3, 3), (3, 1).
std::vector<Shape> compared_shapes();

/// C_u and C_c (Eq. 18-20) of a shape over the span: Figure 4.
struct CoefficientRow {
  Shape shape;
  Rational span;
  Real c_u, c_c;
};
/// The row of one shape at one span.
CoefficientRow coefficient_row(const Shape &shape, const Rational &span);
/// The six shapes of the paper's section 2.4, spans 1/50 to 49/50.
std::vector<CoefficientRow> figure4_rows();

/// The settings of a set: Figures 5 to 7 vary one of N_c, N_pc and N_min from their defaults of 10, 10 and
/// 2000 at s = 0.98, that is R = 99.
struct SetQuestion {
  Shape shape;
  Classing classing = Classing::geometric;
  unsigned classes = 10;
  Representativity wanted{10, 2000, 2};
};
/// Over N_c: geometric classes, then regular ones, each with all compared shapes.
std::vector<SetQuestion> figure5_questions();
/// The same over N_pc.
std::vector<SetQuestion> figure6_questions();
/// The same over N_min.
std::vector<SetQuestion> figure7_questions();

/// A set of Eq. 6-10 and how well it has its curve.
struct SetRow {
  SetQuestion question;
  ClassCounts counts;
  std::vector<Interval>
      c_r; ///< C_r (Eq. 21) of draws with the seeds 1, 2, ...; none of sets that are too large

  /// The mean, the least and the greatest. \pre there are draws
  Interval mean() const;
  Interval least() const;
  Interval greatest() const;
};
/// The draws of a set.
inline constexpr unsigned draws_of_a_set = 10;
/// The row of a set; C_r is taken at 100 sizes, of particles drawn draws_of_a_set times, if the set has at
/// most `most_drawn` particles. Cost: some milliseconds, and 20 microseconds a particle.
SetRow set_row(const SetQuestion &question, const Integer &most_drawn);

/// The particles that a shape takes with default criteria: Figure 8.
struct ShapeQuestion {
  Classing classing;
  Rational span;
  Shape shape;
};
/// The number of particles that a shape takes.
struct ShapeRow {
  ShapeQuestion question;
  Integer particles; ///< max(sum N', N_min): accessible with as many and more
  Real c_u;
};
/// The row of one question.
ShapeRow shape_row(const ShapeQuestion &question);
/// s = 1/10 and 97/100, regular and geometric classes, a and b from 1/2 to 12 in steps of 1/2.
std::vector<ShapeQuestion> figure8_maps();
/// Regular classes, 20 spans, a and b from 1 to 10.
std::vector<ShapeQuestion> figure8_spans();

} // namespace mdm
