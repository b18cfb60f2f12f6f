// Conditions that are added up as a leaf of a tree. Each condition is there once, with the sum of what it
// is taken. In the end multipliers are made integers without a common divisor: the same contradiction
// (Theorem 14) in the fewest digits, which is what a certificate has. The leaves of chains, windows and
// exact programs all end here, so that the same multiples are written in the same way.

#include "match/leaf_sum.hpp"

#include "number/common_denominator.hpp"

namespace mdm {

void reduce_multipliers(TreeNode &leaf) {
  Integer common = 0;
  for (const Multiple &m : leaf.leaf)
    common = gcd(common, m.multiplier);
  for (Multiple &m : leaf.leaf)
    m.multiplier /= common;
}

void set_multipliers(TreeNode &leaf, const std::vector<Rational> &multipliers) {
  const CommonDenominator cleared(multipliers);
  for (std::size_t i = 0; i < leaf.leaf.size(); ++i)
    leaf.leaf[i].multiplier = cleared.numerators[i];
  reduce_multipliers(leaf);
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
