#pragma once
/// \file
/// How far grains broke, told from their curve before and after.

#include "soil/mean_sizes.hpp"

#include <mdm/number/interval.hpp>

#include <vector>

namespace mdm {

/// Relative breakage: the area between the curves after and before, over log size, as a share of what it can
/// become. 0: nothing broke; below 0: the curve became coarser.
struct Breakage {
  /// B_r of Hardin (1985), J. Geotech. Eng. 111, 1177-1192: of all that could pass 0.074 mm, from that size
  /// on.
  Available<RealRange> hardin;
  /// B of Einav (2007), J. Mech. Phys. Solids 55, 1274-1297: towards a fractal curve of dimension 2.6 between
  /// the finest sieve of `before` and the sieve that all of it passed, and between these.
  Available<RealRange> einav;
};

/// Curves are linear in log size between sieves. Bounds are apart where `passing` is not known better, and,
/// for Hardin, where the finest sieve is above 0.074 mm and something passes it: its sizes are not known.
/// \param before  the gradation at the beginning
/// \param passing  the shares of the mass that now pass its openings, in [0, 1] and not descending; as many
Breakage breakage(const GradingCurve &before, const std::vector<Interval> &passing);

} // namespace mdm
