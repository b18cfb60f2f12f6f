// The search leaves its splits; here each leaf of the tree gets its multipliers. The box of a leaf is set in
// the relaxation with less demanded of the aim than the claim, which it cannot have, and the contradiction's
// multiples are taken. Of squares it is the relaxation of a tangent: the one that touches at the least value
// of the box, with slopes as short as will do.

#include "blend/blend_leaves.hpp"

#include "blend/tangent.hpp"

#include <mdm/number/integer.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

std::vector<Rational> rounded_slopes(std::vector<Rational> slopes, unsigned places) {
  const Integer unit = power_of_ten(places);
  for (Rational &slope : slopes)
    slope = ratio(floor(Rational(slope * unit + ratio(1, 2))), unit);
  return slopes;
}

} // namespace

BlendLeaves::BlendLeaves(const BlendProblem &problem, const BlendAnswer &answer)
    : problem_(problem), tree_(answer.tree), relaxation_(problem) {
  if (answer.best.empty())
    return;
  value_ = answer.best.front().value;
  if (problem.aim != BlendAim::squares)
    relaxation_.demand_less(*value_);
}

std::pair<BlendBox, BlendBox> BlendLeaves::halves(const BlendBox &box) const {
  const BlendNode &node = tree_[box.number];
  BlendBox below = box, above = box;
  below.most[node.stockpile] = std::min(below.most[node.stockpile], node.at);
  below.number = node.first;
  above.least[node.stockpile] = std::max(above.least[node.stockpile], node.at + 1);
  above.number = node.first + 1;
  return {std::move(below), std::move(above)};
}

BlendLeaf BlendLeaves::leaf(const BlendBox &box) {
  bound_shares(relaxation_, box);
  if (problem_.aim == BlendAim::squares && relaxation_.least_value())
    return of_squares(box);
  return of_conflict(relaxation_);
}

void BlendLeaves::bound_shares(BlendRelaxation &relaxation, const BlendBox &box) const {
  for (std::size_t i = 0; i < box.least.size(); ++i)
    relaxation.bound_share(i, ratio(box.least[i], problem_.steps), ratio(box.most[i], problem_.steps));
}

BlendLeaf BlendLeaves::of_conflict(BlendRelaxation &relaxation) const {
  [[maybe_unused]] const bool possible = relaxation.is_feasible();
  assert(!possible);
  BlendLeaf leaf{relaxation.needs_aim(), {}};
  using Kind = BlendLimit::Kind;
  for (BlendMultiple &m : relaxation.multiples())
    if (m.limit.kind == Kind::passing || m.limit.kind == Kind::target)
      leaf.multiples.push_back(std::move(m));
  return leaf;
}

/// \pre the relaxation has found the least value of the box
BlendLeaf BlendLeaves::of_squares(const BlendBox &box) {
  const std::vector<Rational> slopes =
      slopes_at(problem_, blend_of(problem_, relaxation_.some_shares()).passing);
  for (const unsigned places : {1U, 3U})
    if (std::optional<BlendLeaf> leaf = of_tangent(box, rounded_slopes(slopes, places)))
      return *std::move(leaf);
  return of_tangent(box, slopes).value();
}

/// Nothing if the tangent may be below the claim in the box.
std::optional<BlendLeaf> BlendLeaves::of_tangent(const BlendBox &box,
                                                 const std::vector<Rational> &slopes) const {
  const Tangent tangent = tangent_with(problem_, slopes);
  BlendRelaxation relaxation(tangent.problem);
  bound_shares(relaxation, box);
  if (*relaxation.least_value() < *value_ + tangent.raised)
    return std::nullopt;
  relaxation.demand_less(*value_ + tangent.raised);
  BlendLeaf leaf = of_conflict(relaxation);
  for (std::size_t s = 0; s < slopes.size(); ++s)
    if (slopes[s] != 0)
      leaf.multiples.push_back({{BlendLimit::Kind::target, s, slopes[s] > 0}, abs(slopes[s])});
  return leaf;
}

} // namespace mdm
