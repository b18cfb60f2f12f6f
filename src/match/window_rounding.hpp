#pragma once
/// \file
/// Matches of a given mass, near what a window's relaxation has found.

#include "match/tolerant_match.hpp"
#include "match/window_relaxation.hpp"

namespace mdm {

/// Rounds counts at one mass, coarse classes first and the others anew after each, and tests exactly what
/// comes out.
class WindowRounding {
public:
  WindowRounding(const TolerantProblem &problem, const MassWindows &windows,
                 const WindowRelaxation &relaxation)
      : problem_(problem), windows_(windows), relaxation_(relaxation) {}

  /// A match within bounds on counts, with fewer particles than `limit`; nothing if none is found.
  std::optional<TolerantMatch> match(double mass, const CountBounds &bounds, double limit,
                                     double excess_price) const;

private:
  std::vector<double> rounded(const WindowPoint &point, double mass) const;
  std::optional<TolerantMatch> tested(const std::vector<double> &counts, double mass) const;
  std::vector<Rational> exact_shares(const std::vector<double> &near_shares) const;

  const TolerantProblem &problem_;
  const MassWindows &windows_;
  const WindowRelaxation &relaxation_;
};

} // namespace mdm
