#pragma once
/// \file
/// Matches of a given mass, near what a window's relaxation has found.

#include "match/count_walk.hpp"
#include "match/tolerant_match.hpp"
#include "match/window_relaxation.hpp"

namespace mdm {

/// Proposes whole counts at one mass, and tests exactly what comes out.
class WindowRounding {
public:
  WindowRounding(const TolerantProblem &problem, const MassWindows &windows,
                 const WindowRelaxation &relaxation);

  /// A match within bounds on counts, with fewer particles than `limit`; nothing if none is found.
  std::optional<TolerantMatch> match(double mass, const CountBounds &bounds, double limit,
                                     double excess_price) const;
  /// About as few particles as a match with a mass in the window has, or fewer; infinite where there is none
  /// with fewer than `limit`. \pre walks()
  double fewest(const NearWindow &window, double limit) const;
  /// True if a walk over the classes finds the counts, in the time of some solutions of the relaxation.
  bool walks() const { return !problem_.tolerance().total && !problem_.weight(); }

private:
  std::optional<TolerantMatch> walked(const NearWindow &at, double limit) const;
  std::vector<double> rounded(const WindowPoint &point, double mass) const;
  void add_missing(std::vector<double> &counts, double mass) const;
  std::optional<std::vector<Rational>> masses(const std::vector<Integer> &q, const Rational &mass) const;
  std::optional<TolerantMatch> tested(const std::vector<double> &counts, double mass) const;
  std::vector<Rational> exact_shares(const std::vector<double> &near_shares) const;

  const TolerantProblem &problem_;
  const MassWindows &windows_;
  const WindowRelaxation &relaxation_;
  CountWalk walk_;
};

} // namespace mdm
