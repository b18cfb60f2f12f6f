#pragma once
/// \file
/// A sum of conditions as the leaf of a tree.

#include <mdm/match/evidence.hpp>
#include <mdm/number/rational.hpp>

#include <map>
#include <tuple>
#include <vector>

namespace mdm {

/// Divides a leaf's multipliers by their greatest common divisor.
/// \pre some are not 0
void reduce_multipliers(TreeNode &leaf);

/// Gives a leaf's conditions their multipliers: integers without a common divisor in the ratios of these.
/// \pre as many as the leaf has conditions, all >= 0, some > 0
void set_multipliers(TreeNode &leaf, const std::vector<Rational> &multipliers);

/// Multiples of conditions that are added up, each condition once.
class LeafSum {
public:
  void add(TolerantCondition condition, std::size_t j, const Rational &m) { add(condition, j, j, m); }
  /// Of classes i to j.
  void add(TolerantCondition condition, std::size_t i, std::size_t j, const Rational &m);
  void add(const LeafSum &other, const Rational &m);
  /// With integers without a common divisor as multipliers.
  /// \pre all multipliers are >= 0, some is > 0
  TreeNode node() const;

private:
  std::map<std::tuple<TolerantCondition, std::size_t, std::size_t>, Rational> sum_;
};

} // namespace mdm
