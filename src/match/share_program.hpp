#pragma once
/// \file
/// The cheapest shares of the classes, in double precision.

#include <cstddef>
#include <vector>

namespace mdm {

/// A part of a class's share, from its last part on: shares up to `length` more at a constant cost each.
struct SharePiece {
  double slope; ///< cost of a share
  double length;
  double particles, excess; ///< of a share, parts of the cost
  std::size_t j;
};

/// Convex costs of the classes' shares: each class has its least share, and pieces of ascending slopes.
struct ShareCosts {
  std::vector<double> least;
  std::vector<SharePiece> pieces; ///< by class, ascending slopes in each
};

/// Bounds on the shares of the classes up to one.
struct ShareBand {
  double lo = 0, hi = 1;
};

/// Shares y_j that sum up to 1.
struct CheapShares {
  bool exist = false;
  std::vector<double> y, particles; ///< beyond the particles of the least shares
  double cost = 0, excess = 0;      ///< beyond those of the least shares
  /// What a share of each class costs, so that no other shares in the bands are cheaper than these; where
  /// there are none, 1 or -1 in consecutive classes, which show it.
  std::vector<double> prices;
};

/// The cheapest shares with sums in the bands, the last of which is [1, 1]. Cost: a sorted merge of the
/// pieces where bands bind.
CheapShares cheapest_shares(const ShareCosts &costs, const std::vector<ShareBand> &bands);

} // namespace mdm
