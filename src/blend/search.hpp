#pragma once
/// \file
/// The search for the best blends in steps.

#include "blend/blend_box.hpp"
#include "blend/relaxation.hpp"

#include <map>

namespace mdm {

/// Branch and bound over boxes of counts n_i, the shares n_i / steps. Boxes are opened in the order of the
/// least value that real numbers allow in them; of those with the same value, in the order of the first
/// shares with it, which are looked for where a blend of that value is known. So blends come in the stated
/// order.
class BlendSearch {
public:
  using Counts = std::vector<std::uint64_t>;

  BlendSearch(const BlendProblem &problem, const Watch &watch, std::uint64_t node_limit);

  /// The next best blend; nothing where there are no more, or a limit came first.
  std::optional<Counts> next();
  /// True if the watch or the limit of nodes ended it.
  bool is_limited() const { return is_limited_; }
  /// No blend that is left has a lower value; nothing if none is left.
  std::optional<Rational> least_value() const;
  /// The best of those that were seen, but may not be the next; nothing if there is none.
  std::optional<Counts> seen() const;
  std::uint64_t splits() const { return (tree_.size() - 1) / 2; }
  /// All splits so far.
  const std::vector<BlendNode> &tree() const { return tree_; }

private:
  struct Box : BlendBox {
    std::vector<Rational> shares; ///< with the least value, within the box
  };
  /// The least value, and the first shares with it where they are known: what has none comes first.
  using Key = std::vector<Rational>;
  using Open = std::multimap<Key, Box>;

  Rational share(std::uint64_t count) const;
  std::optional<Counts> blend_at(const std::vector<Rational> &shares) const;
  void bound(const Box &box);
  void open(Box box);
  void order(Open::iterator place);
  void split(Open::iterator place);
  void exclude(Box box, const Counts &counts);
  std::pair<Box, Box> halves(const Box &box, std::size_t stockpile, std::uint64_t at);

  const BlendProblem &problem_;
  BlendRelaxation relaxation_;
  std::uint64_t node_limit_;
  Open open_;
  std::vector<BlendNode> tree_;
  std::optional<Rational> known_;              ///< the value of a blend that is among the open boxes
  std::optional<std::pair<Box, Counts>> last_; ///< what next() gave
  bool is_limited_ = false;
};

} // namespace mdm
