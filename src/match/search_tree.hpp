#pragma once
/// \file
/// The nodes of a search, with what is certain of each.

#include "match/mass_window.hpp"

#include <mdm/match/evidence.hpp>

#include <memory>
#include <set>

namespace mdm {

/// A tree of splits. Each node has a bound of its own: no match in it has fewer particles, or there is none,
/// and a leaf that shows it. Open nodes are those that are neither split nor closed.
class SearchTree {
public:
  /// The root's bound is known without a leaf.
  SearchTree(Integer bound, bool keep_leaves);

  using Number = std::size_t;
  /// The open node with the least bound, the latest of several.
  std::optional<Number> next() const;
  /// Its splits, in any order, as bounds.
  void apply_splits(Number node, CountBounds &bounds, MassWindow &window) const;

  const Integer &bound(Number node) const { return nodes_[node].bound; }
  /// If the bound is greater than what is known.
  void raise(Number node, const Integer &bound, TreeNode leaf);
  /// No match is in the node, or only those with as many particles as its bound, of which there are enough.
  void close(Number node);
  void close_without_match(Number node, TreeNode leaf);
  /// The first of two new nodes: with q_j < v, then >= v.
  Number split(Number node, std::size_t j, const Integer &v);
  /// The same with M <= mass, then M > mass.
  Number split(Number node, const Rational &mass);

  bool has_open() const { return !open_.empty(); }
  /// Least bound of all nodes that are not split and may hold a match; nothing if there are none.
  std::optional<Integer> least_bound() const;
  /// Refutes fewer than `bound` particles, at most the least bound and more than the root had at first. Empty
  /// if it has more than `longest` nodes and multiples, or the leaves were not kept.
  Tree tree(const Integer &bound, std::size_t longest) const;

private:
  struct Node {
    Number parent = 0;
    Integer bound;
    std::shared_ptr<const TreeNode> leaf;
    std::size_t j = 0;
    Integer v;
    std::optional<Rational> mass; ///< of a split of it
    Number first = 0;             ///< of the two children, 0 for none
    bool has_match = true;
  };
  Number add_children(Number node);
  std::vector<Node> nodes_;
  std::set<std::pair<Integer, Number>> open_;
  std::optional<Integer> closed_; ///< least bound of those closed
  bool keep_leaves_;
};

} // namespace mdm
