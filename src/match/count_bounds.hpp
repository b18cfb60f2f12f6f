#pragma once
/// \file
/// Bounds on the counts of classes.

#include "match/tolerant_problem.hpp"

#include <algorithm>
#include <optional>
#include <vector>

namespace mdm {

/// Bounds on the particles of a class.
struct CountBound {
  Integer least = 0;
  std::optional<Integer> most;

  /// True if fewer than v and at least v are both within the bounds.
  bool is_inside(const Integer &v) const { return least < v && (!most || v <= *most); }
  /// To fewer than v, the first branch of a split, or to at least v.
  void narrow(const Integer &v, bool is_first) {
    if (!is_first)
      least = std::max(least, v);
    else if (!most || *most >= v)
      most = v - 1;
  }
};

/// The bounds in force at a node of a search, of each class.
using CountBounds = std::vector<CountBound>;

/// Those of the question.
inline CountBounds least_counts(const TolerantProblem &problem) {
  CountBounds bounds;
  for (std::size_t j = 0; j < problem.classes(); ++j)
    bounds.push_back({problem.least(j), std::nullopt});
  return bounds;
}

} // namespace mdm
