// Shortens the tree of windows before it is written. Walking it from the leaves up, with the bounds in
// force: a leaf's prices lose all digits that it can do without, and where one of two branches is a leaf
// that refutes the whole node, it takes the node's place. What is kept is tested with MassWindows::verdict,
// so that the tree proves what it did.

#include "match/window_evidence.hpp"

#include <iterator>

namespace mdm {
namespace {

/// Walks the tree with the bounds in force.
class Shortening {
public:
  Shortening(const MassWindows &windows, const Tree &tree, const Integer &particles)
      : windows_(windows), tree_(tree), particles_(particles) {}

  /// The next subtree.
  Tree subtree(const MassWindow &window, const CountBounds &bounds) {
    const TreeNode &node = tree_[next_++];
    if (!node.is_split())
      return {node.is_window ? short_leaf(node, window, bounds) : node};
    Tree all{node};
    std::vector<Tree> branches;
    for (const bool is_first : {true, false}) {
      MassWindow half = window;
      CountBounds counts = bounds;
      if (node.mass)
        half.narrow(*node.mass, is_first);
      else
        counts[node.j].narrow(node.v, is_first);
      branches.push_back(subtree(half, counts));
    }
    for (const Tree &branch : branches)
      if (branch.size() == 1 && branch.front().is_window && refutes(branch.front(), window, bounds))
        return {short_leaf(branch.front(), window, bounds)};
    for (Tree &branch : branches)
      all.insert(all.end(), std::make_move_iterator(branch.begin()), std::make_move_iterator(branch.end()));
    return all;
  }

private:
  bool refutes(const TreeNode &leaf, const MassWindow &window, const CountBounds &bounds) const {
    const WindowPrices prices = windows_.prices_of(leaf);
    const WindowVerdict found = windows_.verdict(window, bounds, prices);
    return found.is_refuted || (prices.particles > 0 && found.particles >= particles_);
  }
  TreeNode short_leaf(const TreeNode &leaf, const MassWindow &window, const CountBounds &bounds) const {
    return windows_.leaf(windows_.shortened(window, bounds, windows_.prices_of(leaf), particles_));
  }

  const MassWindows &windows_;
  const Tree &tree_;
  const Integer &particles_;
  std::size_t next_ = 0;
};

} // namespace

Tree shortened(const MassWindows &windows, const Tree &tree, const CountBounds &bounds,
               const Integer &particles) {
  return tree.empty() ? Tree() : Shortening(windows, tree, particles).subtree({}, bounds);
}

} // namespace mdm
