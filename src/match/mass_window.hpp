#pragma once
/// \file
/// Windows of the mass: what is certain of all matches whose total mass M is in one.

#include "match/count_bounds.hpp"
#include "match/tolerant_problem.hpp"

#include <mdm/match/evidence.hpp>

namespace mdm {

/// above < M <= up_to, in units of the problem's masses.
struct MassWindow {
  Rational above = 0;
  std::optional<Rational> up_to; ///< nothing: infinite

  /// To M <= mass, or to M > mass.
  void narrow(const Rational &mass, bool is_first);
};

/// Multiples of the conditions of a window: each class's share y_j is taken `shares[j]` times, as conditions
/// on what passes and on the whole say it.
struct WindowPrices {
  std::vector<Integer> shares;
  Integer excess = 0, weight = 0;      ///< >= 0
  Integer particles = 0, at_least = 0; ///< >= 0: of `fewer` and of `at_least`
};

/// What the sum of a window's conditions says.
struct WindowVerdict {
  bool is_refuted = false; ///< there is no match
  Integer particles = 0;   ///< else no match has fewer
};

/// The leaves of windows (proofs/README.md, Theorem 20; proofs/certificate-format.md, section 6), exactly.
class MassWindows {
public:
  explicit MassWindows(const TolerantProblem &problem);

  /// l_j and h_j, which every share keeps.
  const std::vector<ShareBounds> &shares() const { return shares_; }
  /// \pre the excess has no price without a total, the weight none where none is demanded
  WindowVerdict verdict(const MassWindow &window, const CountBounds &bounds,
                        const WindowPrices &prices) const;
  TreeNode leaf(const WindowPrices &prices) const;
  /// Those of a leaf.
  WindowPrices prices_of(const TreeNode &leaf) const;
  /// The prices with the fewest digits that still refute fewer particles than `particles`, or any number
  /// where these prices do.
  WindowPrices shortened(const MassWindow &window, const CountBounds &bounds, const WindowPrices &prices,
                         const Integer &particles) const;

private:
  Rational right_side(const MassWindow &window, const WindowPrices &prices) const;

  const TolerantProblem &problem_;
  std::vector<ShareBounds> shares_;
  Integer unit_; ///< in which all that follows are integers
  std::vector<Integer> l_, h_, target_, per_mass_;
  std::vector<Integer> f_, F_; ///< in the unit, too
};

} // namespace mdm
