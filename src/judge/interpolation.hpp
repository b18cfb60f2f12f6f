#pragma once
/// \file
/// The place of a size between the sieves of a box.

#include "judge/curve_box.hpp"
#include "number/real.hpp"

namespace mdm {

/// A size at the sieve i, or strictly between the sieves i and i + 1, which are above 0: then at
/// (log size - log x_i) / (log x_{i+1} - log x_i) of the way.
struct CurvePlace {
  std::size_t i;
  std::optional<Real> way;
};

/// Of a size above the largest sieve that one, which as much passes.
/// \pre size (mm) is not strictly between 0 and x_1
CurvePlace place_of(const CurveBox &box, const Rational &size);

/// The same of any size from 0 on, where nothing passes what lies below x_1.
/// \pre size (mm) is not between 0 and x_1 if something may pass x_1
CurvePlace place_on(const CurveBox &box, const Rational &size);

/// c y, exactly 0 if c is.
Real scaled(const Real &c, const Real &y);

/// What passes there on the curve through these percents.
Real passing_at(const CurvePlace &place, const std::vector<Rational> &percents);

} // namespace mdm
