#include "match/leaf_sum.hpp"

#include "number/common_denominator.hpp"

namespace mdm {

void set_multipliers(TreeNode &leaf, const std::vector<Rational> &multipliers) {
  const CommonDenominator cleared(multipliers);
  Integer common = 0;
  for (const Integer &n : cleared.numerators)
    common = gcd(common, n);
  for (std::size_t i = 0; i < leaf.leaf.size(); ++i)
    leaf.leaf[i].multiplier = cleared.numerators[i] / common;
}

void LeafSum::add(TolerantCondition condition, std::size_t i, std::size_t j, const Rational &m) {
  if (m != 0)
    sum_[{condition, i, j}] += m;
}

void LeafSum::add(const LeafSum &other, const Rational &m) {
  for (const auto &[condition, multiplier] : other.sum_)
    sum_[condition] += m * multiplier;
}

TreeNode LeafSum::node() const {
  std::vector<Rational> multipliers;
  TreeNode node;
  for (const auto &[of, m] : sum_) {
    const auto &[condition, i, j] = of;
    multipliers.push_back(m);
    node.leaf.push_back({condition, j, 0, i});
  }
  set_multipliers(node, multipliers);
  return node;
}

} // namespace mdm
