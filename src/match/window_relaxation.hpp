#pragma once
/// \file
/// Matches with their mass in a window, without whole numbers, in double precision.

#include "match/mass_window.hpp"
#include "match/share_program.hpp"

#include <limits>

namespace mdm {

/// A window and bounds on the classes' counts, in doubles: 0 and infinite where there are none.
struct NearWindow {
  double above = 0, up_to = std::numeric_limits<double>::infinity();
  std::vector<double> least, most;

  NearWindow(const MassWindow &window, const CountBounds &bounds);
};

/// What is cheapest in a window: bounds on the number of particles, and the counts near which matches may be.
struct WindowPoint {
  double particles = 0; ///< a match has about so many or more; infinite where there is none
  std::vector<double> counts, shares;
  /// Of shares, and of the conditions of a window: what makes the bound.
  struct Prices {
    double particles = 1, at_least = 0, excess = 0, weight = 0;
    std::vector<double> shares;
  } prices;

  bool exists() const { return particles < std::numeric_limits<double>::infinity(); }
  /// As integers, with as many digits as doubles have.
  WindowPrices exact_prices() const;
};

/// A count with a share that so many particles can have.
struct MenuPoint {
  double share, count;
};

/// Classes are taken as the convex hulls of their points (counts and shares), which are few; the excess of a
/// total and a demanded weight have prices, of which the best are found along tangents. Its bounds are those
/// of a linear program over the hulls.
class WindowRelaxation {
public:
  WindowRelaxation(const TolerantProblem &problem, const MassWindows &windows);

  /// \param enough  ends where there are so many particles
  /// \param excess_price  about that of a window nearby
  WindowPoint minimise(const NearWindow &window, double enough, double excess_price) const;
  /// Shares of a match with these counts and this mass, not too near to the bounds. Nothing if none are
  /// found.
  std::vector<double> shares_of(const std::vector<double> &counts, double mass) const;

  double f(std::size_t j) const { return f_[j]; }
  double F(std::size_t j) const { return F_[j]; }
  const ShareBand &share(std::size_t j) const { return shares_[j]; }
  /// Of the classes up to j.
  const ShareBand &passing(std::size_t j) const { return bands_[j]; }

private:
  struct Menus;
  struct Priced;
  enum class Aim { fewest, most, any };
  bool make_menus(Menus &menus, const NearWindow &window) const;
  Priced priced(const Menus &menus, Aim aim, double excess_price, double weight_price) const;
  Priced best_excess_price(const Menus &menus, double weight_price, double start, double enough) const;

  const TolerantProblem &problem_;
  std::size_t k_;
  std::vector<double> f_, F_, target_, per_mass_;
  std::vector<ShareBand> shares_, bands_;
  double half_total_, weight_;
};

} // namespace mdm
