#pragma once
/// \file
/// The exact linear program of a node of a search.

#include "match/count_bounds.hpp"
#include "match/simplex.hpp"
#include "match/tolerant_match.hpp"

namespace mdm {

/// Decides what double precision cannot. Cost: up to seconds with 50 classes and more.
class ExactNode {
public:
  /// All that takes long throws Simplex::Interrupted soon after the watch's end.
  ExactNode(const TolerantProblem &problem, const Watch &watch);

  /// Looks for the fewest particles within bounds on counts, at most `most`. False if there is nothing.
  bool find(const CountBounds &bounds, const std::optional<Integer> &most);
  /// Refutes what was looked for; whether it counts the particles.
  TreeNode leaf() const;
  /// Masses of the classes.
  std::vector<Rational> masses() const;
  /// The coarsest class whose count is no whole number, or that holds no mass above its lower bound and could
  /// be empty: and v, so that q_j < v and q_j >= v are narrower than what was looked at.
  std::pair<std::size_t, Integer> split() const;

private:
  void set(std::size_t variable, const CountBound &bound);

  const TolerantProblem &problem_;
  Simplex program_;
  std::vector<Multiple> row_of_;    ///< condition of each form
  std::vector<std::size_t> strict_; ///< forms of above_lower
  std::size_t count_ = 0;           ///< form of at_least
};

} // namespace mdm
