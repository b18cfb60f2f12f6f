#pragma once
/// \file
/// Whole counts near those of a linear program, in double precision.

#include "match/share_closure.hpp"

namespace mdm {

/// Rounds counts so that they may be a match: what only an exact test shows.
class CountRounding {
public:
  CountRounding(const TolerantProblem &problem, const ShareClosure &shares);

  /// What a linear program has found.
  struct Point {
    std::vector<double> counts, masses;
    std::vector<double> least; ///< bounds on the counts
  };
  /// Few particles with which the masses of sums of consecutive classes can all be had, near the point.
  /// Nothing if they would be `most` or more.
  std::optional<std::vector<double>> rounded(const Point &point, double most) const;

private:
  /// The masses M between which sums of consecutive classes have their shares.
  struct Window {
    double above, up_to;
  };
  Window window(const std::vector<double> &q) const;
  std::vector<double> along_curve(const Point &point, double growth, bool hold) const;
  std::vector<double> by_shares(const Point &point, double mass) const;
  double lo(std::size_t i, std::size_t j) const { return lo_[i * k_ + j]; }
  double hi(std::size_t i, std::size_t j) const { return hi_[i * k_ + j]; }

  std::size_t k_;
  std::vector<double> f_, F_, lo_, hi_;
};

} // namespace mdm
