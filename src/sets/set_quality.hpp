#pragma once
/// \file
/// The agreement of a set of particles with its grading curve.

#include "sets/size_classes.hpp"

#include <mdm/number/interval.hpp>

namespace mdm {

/// Takes `count` particles of a size.
using TakeSize = std::function<void(const Enclosure &size, const Integer &count)>;

/// Hands on the particles of class j, counted from 0; the same ones each time.
using ParticlesOf = std::function<void(std::size_t j, const TakeSize &take)>;

/// Measures of a set whose particles have volumes proportional to d^D. Intervals are as wide as the
/// enclosures of the sizes make them.
struct SetQuality {
  std::vector<Interval> shares;  ///< of the set's volume, one a class
  std::vector<Interval> largest; ///< share of the largest particle in the volume of its class; 0: empty class
  Interval worst_error;          ///< the largest |share - f_v|
  Interval c_r;                  ///< C_r (Eq. 21)
  Interval c_u, c_c;             ///< with d_p the least size up to which the share p of the volume lies
};

/// C_r is taken at `points` >= 2 sizes d_min (d_max / d_min)^(i / (points - 1)), i = 0, 1, ..., the last of
/// which all particles pass;
/// `exact_shares` are the shares of the classes where they are known, as for a match. Cost: some microseconds
/// a size; memory for the sizes of one class.
/// \pre there is a particle
SetQuality set_quality(const ModelCurve &curve, const std::vector<SizeClass> &classes, unsigned dimension,
                       unsigned points, const ParticlesOf &particles,
                       const std::optional<std::vector<Rational>> &exact_shares = std::nullopt);

/// A number in an interval, for rounded() and enclose(): no precision makes it narrower.
Real real_in(const Interval &i);

} // namespace mdm
