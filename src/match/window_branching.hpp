#pragma once
/// \file
/// How a search within a tolerance goes on in a window of the mass.

#include "match/window_rounding.hpp"

namespace mdm {

/// Proposes bounds, matches and splits of windows, and of counts inside narrow ones.
class WindowBranching {
public:
  /// \param mass  about that of the matches with the fewest particles
  WindowBranching(const TolerantProblem &problem, Rational mass);

  const MassWindows &windows() const { return windows_; }
  WindowPoint minimise(const MassWindow &window, const CountBounds &bounds, double enough,
                       double excess_price) const {
    return relaxation_.minimise(NearWindow(window, bounds), enough, excess_price);
  }
  /// A match in the middle of the window with fewer particles than `limit`, if one is found.
  std::optional<TolerantMatch> match(const MassWindow &window, const CountBounds &bounds, double limit,
                                     double excess_price) const;

  const WindowRounding &rounding() const { return rounding_; }

  /// M <= mass, or M > mass; or q_j < v, or q_j >= v.
  struct Split {
    std::optional<Rational> mass;
    std::size_t j = 0;
    Integer v;
  };
  /// Nothing if all counts are whole, and the window is too narrow for doubles, or narrow where the exact
  /// program is small.
  std::optional<Split> best_split(const MassWindow &window, const CountBounds &bounds,
                                  const WindowPoint &point, double limit) const;

private:
  std::optional<Rational> middle(const MassWindow &window) const;
  std::vector<Split> count_splits(const CountBounds &bounds, const WindowPoint &point) const;
  double merit(const Split &split, const MassWindow &window, const CountBounds &bounds,
               const WindowPoint &point, double limit) const;

  const TolerantProblem &problem_;
  MassWindows windows_;
  WindowRelaxation relaxation_;
  WindowRounding rounding_;
  Rational mass_;
};

} // namespace mdm
