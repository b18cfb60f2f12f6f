#pragma once
/// \file
/// The leaves of a search for blends, with the multipliers that prove them.

#include "blend/blend_box.hpp"
#include "blend/relaxation.hpp"

#include <mdm/blend/blend.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// Why no blend of a box has a lower value than the best one, or why there is none in it.
struct BlendLeaf {
  bool is_of_aim = false;               ///< the first of these
  std::vector<BlendMultiple> multiples; ///< of sieves and targets: those of the shares follow
};

/// The multipliers of leaves (Theorem 22).
class BlendLeaves {
public:
  BlendLeaves(const BlendProblem &problem, const BlendAnswer &answer);

  /// The two halves of a box whose node is split.
  std::pair<BlendBox, BlendBox> halves(const BlendBox &box) const;
  /// \pre restrict_box() was true of it, and its node is not split
  BlendLeaf leaf(const BlendBox &box);

private:
  void bound_shares(BlendRelaxation &relaxation, const BlendBox &box) const;
  BlendLeaf of_conflict(BlendRelaxation &relaxation) const;
  BlendLeaf of_squares(const BlendBox &box);
  std::optional<BlendLeaf> of_tangent(const BlendBox &box, const std::vector<Rational> &slopes) const;

  const BlendProblem &problem_;
  const std::vector<BlendNode> &tree_;
  std::optional<Rational> value_; ///< of the claim; nothing where there is no blend
  BlendRelaxation relaxation_;
};

} // namespace mdm
