#pragma once
/// \file
/// Bounds on the counts of consecutive classes.

#include "match/tolerant_problem.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace mdm {

/// Bounds on the particles of classes i to j together.
struct CountBound {
  Integer least = 0;
  std::optional<Integer> most;
};

/// The bounds in force at a node of a search: of each class, and of sums of several.
struct CountBounds {
  std::vector<CountBound> classes;
  std::map<std::pair<std::size_t, std::size_t>, CountBound> sums; ///< i < j

  /// True if q_i + ... + q_j < v and >= v are both within the bounds, as far as these are of the same
  /// classes.
  bool is_inside(std::size_t i, std::size_t j, const Integer &v) const {
    const auto known = sums.find({i, j});
    if (i < j && known == sums.end())
      return v > 0;
    const CountBound &bound = i == j ? classes[j] : known->second;
    return bound.least < v && (!bound.most || v <= *bound.most);
  }
  CountBound &of(std::size_t i, std::size_t j) { return i == j ? classes[j] : sums[{i, j}]; }
};

/// Those of the question.
inline CountBounds least_counts(const TolerantProblem &problem) {
  CountBounds bounds;
  for (std::size_t j = 0; j < problem.classes(); ++j)
    bounds.classes.push_back({problem.least(j), std::nullopt});
  return bounds;
}

} // namespace mdm
