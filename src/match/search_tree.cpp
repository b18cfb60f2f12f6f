// The nodes of a search with their bounds and leaves. A node knows its parent and the split that leads to
// it, so that the bounds in force are had by walking up; only open nodes are in a queue, the least bound
// first. Bounds of a child begin with that of its parent, and its leaf: what was proved of all is true of a
// part.
//
// The tree for the certificate is made at the end: a subtree whose root already has the bound that is to be
// proved is its leaf, so that splits which were of no use are not in it.

#include "match/search_tree.hpp"

#include <algorithm>
#include <limits>

namespace mdm {

SearchTree::SearchTree(Integer bound, bool keep_leaves) : keep_leaves_(keep_leaves) {
  open_.insert({bound, 0});
  nodes_.emplace_back();
  nodes_[0].bound = std::move(bound);
}

std::optional<SearchTree::Number> SearchTree::next() const {
  if (open_.empty())
    return std::nullopt;
  const auto end = open_.upper_bound({open_.begin()->first, std::numeric_limits<Number>::max()});
  return std::prev(end)->second;
}

void SearchTree::apply_splits(Number node, CountBounds &bounds, MassWindow &window) const {
  for (; node != 0; node = nodes_[node].parent) {
    const Node &parent = nodes_[nodes_[node].parent];
    const bool is_first = node == parent.first;
    if (parent.mass)
      window.narrow(*parent.mass, is_first);
    else
      bounds[parent.j].narrow(parent.v, is_first);
  }
}

void SearchTree::raise(Number node, const Integer &bound, TreeNode leaf) {
  Node &of = nodes_[node];
  if (bound <= of.bound)
    return;
  open_.erase({of.bound, node});
  of.bound = bound;
  open_.insert({bound, node});
  if (keep_leaves_)
    of.leaf = std::make_shared<const TreeNode>(std::move(leaf));
}

void SearchTree::close(Number node) {
  open_.erase({nodes_[node].bound, node});
  closed_ = closed_ ? std::min(*closed_, nodes_[node].bound) : nodes_[node].bound;
}

void SearchTree::close_without_match(Number node, TreeNode leaf) {
  open_.erase({nodes_[node].bound, node});
  nodes_[node].has_match = false;
  if (keep_leaves_)
    nodes_[node].leaf = std::make_shared<const TreeNode>(std::move(leaf));
}

SearchTree::Number SearchTree::add_children(Number node) {
  open_.erase({nodes_[node].bound, node});
  const Number first = nodes_.size();
  for (const Number child : {first, first + 1}) {
    nodes_.push_back({node, nodes_[node].bound, nodes_[node].leaf, 0, 0, std::nullopt, 0, true});
    open_.insert({nodes_[node].bound, child});
  }
  nodes_[node].leaf.reset();
  nodes_[node].first = first;
  return first;
}

SearchTree::Number SearchTree::split(Number node, std::size_t j, const Integer &v) {
  const Number first = add_children(node);
  nodes_[node].j = j;
  nodes_[node].v = v;
  return first;
}

SearchTree::Number SearchTree::split(Number node, const Rational &mass) {
  const Number first = add_children(node);
  nodes_[node].mass = mass;
  return first;
}

std::optional<Integer> SearchTree::least_bound() const {
  if (open_.empty())
    return closed_;
  const Integer &open = open_.begin()->first;
  return closed_ ? std::min(*closed_, open) : open;
}

Tree SearchTree::tree(const Integer &bound, std::size_t longest) const {
  Tree tree;
  std::size_t size = 0;
  std::vector<Number> left{0};
  while (!left.empty()) {
    const Node &node = nodes_[left.back()];
    left.pop_back();
    if (node.first != 0) {
      tree.push_back({node.j, node.j, node.v, {}, node.mass});
      left.push_back(node.first + 1);
      left.push_back(node.first);
    } else if (!node.leaf || (node.has_match && node.bound < bound)) {
      return {};
    } else {
      tree.push_back(*node.leaf);
      size += node.leaf->leaf.size();
    }
    if (++size > longest)
      return {};
  }
  return tree;
}

} // namespace mdm
