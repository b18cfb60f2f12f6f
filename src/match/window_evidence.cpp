// Shortens the tree of windows before it is written. Walking it from the leaves up, with the bounds in
// force: a leaf's prices lose all digits that it can do without, and where one of two branches is a leaf
// that refutes the whole node, it takes the node's place. What is kept is tested with MassWindows::verdict,
// so that the tree proves what it did. Once the watch ends, the rest stays as it is.

#include "match/window_evidence.hpp"

#include <utility>

namespace mdm {
namespace {

/// Walks the tree with the bounds in force. Without a watch leaves keep their digits.
class Shortening {
public:
  Shortening(const MassWindows &windows, const Tree &tree, const Integer &particles, const Watch *watch)
      : windows_(windows), tree_(tree), particles_(particles), watch_(watch) {}

  /// Writes the next subtree.
  void subtree(const MassWindow &window, const CountBounds &bounds) {
    const TreeNode &node = tree_[next_++];
    if (!node.is_split()) {
      written_.push_back(node.is_window ? short_leaf(node, window, bounds) : node);
      return;
    }
    const std::size_t begin = written_.size();
    written_.push_back(node);
    const std::size_t first = branch(node, true, window, bounds);
    const std::size_t second = branch(node, false, window, bounds);
    for (const std::size_t leaf : {first, second})
      if (leaf > 0 && !is_over() && refutes(written_[leaf], window, bounds)) {
        const TreeNode kept = short_leaf(written_[leaf], window, bounds);
        written_.resize(begin);
        written_.push_back(kept);
        return;
      }
  }

  Tree written() && { return std::move(written_); }

private:
  bool is_over() const { return watch_ != nullptr && watch_->ends(); }

  /// Writes a branch of the node. \return where it is, if that is one leaf of a window; else 0
  std::size_t branch(const TreeNode &node, bool is_first, MassWindow window, CountBounds bounds) {
    if (node.mass)
      window.narrow(*node.mass, is_first);
    else
      bounds[node.j].narrow(node.v, is_first);
    const std::size_t begin = written_.size();
    subtree(window, bounds);
    return written_.size() == begin + 1 && written_[begin].is_window ? begin : 0;
  }

  bool refutes(const TreeNode &leaf, const MassWindow &window, const CountBounds &bounds) const {
    const WindowPrices prices = windows_.prices_of(leaf);
    const WindowVerdict found = windows_.verdict(window, bounds, prices);
    return found.is_refuted || (prices.particles > 0 && found.particles >= particles_);
  }
  TreeNode short_leaf(const TreeNode &leaf, const MassWindow &window, const CountBounds &bounds) const {
    if (watch_ == nullptr || watch_->ends())
      return leaf;
    return windows_.leaf(windows_.shortened(window, bounds, windows_.prices_of(leaf), particles_));
  }

  const MassWindows &windows_;
  const Tree &tree_;
  const Integer &particles_;
  const Watch *watch_;
  std::size_t next_ = 0;
  Tree written_; ///< so far: what is read next goes to its end, so that deep trees take no longer
};

Tree walked(const MassWindows &windows, const Tree &tree, const CountBounds &bounds, const Integer &particles,
            const Watch *watch) {
  if (tree.empty())
    return {};
  Shortening shortening(windows, tree, particles, watch);
  shortening.subtree({}, bounds);
  return std::move(shortening).written();
}

} // namespace

Tree shortened(const MassWindows &windows, const Tree &tree, const CountBounds &bounds,
               const Integer &particles, const Watch &watch) {
  return walked(windows, tree, bounds, particles, &watch);
}

Tree for_fewer(const MassWindows &windows, const Tree &tree, const CountBounds &bounds,
               const Integer &particles) {
  return walked(windows, tree, bounds, particles, nullptr);
}

} // namespace mdm
