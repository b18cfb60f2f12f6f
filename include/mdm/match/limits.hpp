#pragma once
/// \file
/// When a search stops before its end.

#include <mdm/number/rational.hpp>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <optional>

namespace mdm {

/// The steps after which a sweep ends with its bounds unless it is allowed more; and the longest chain that
/// is kept (256 MiB). Sieves some 1e-12 apart would have 10^12 steps.
inline constexpr std::uint64_t most_steps = std::uint64_t{1} << 26;

/// When to stop before the end, and what to keep. A step is a raise of the lower bound on the scale.
struct Limits {
  std::optional<std::uint64_t> max_steps = std::nullopt; ///< of a sweep, in the place of most_steps
  std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt;
  std::optional<std::uint64_t> node_limit = std::nullopt; ///< of a search tree
  std::optional<Integer> at_most = std::nullopt;          ///< more particles than this need no exact number
  std::optional<Integer> enough = std::nullopt; ///< no match with fewer particles than this is needed
  std::optional<Rational> gap = std::nullopt; ///< ends a search where the match has so little more, relative
                                              ///< to its particles, than is certain
  bool keep_proof = true; ///< keep what a proof is written from: the chain of a sweep, the tree of a search

  /// True if a match with n particles is close enough to a bound.
  bool is_close(const Integer &n, const Integer &bound) const {
    return gap && Rational(Integer(n - bound)) <= *gap * Rational(n);
  }

  /// Steps that a sweep may take.
  std::uint64_t steps() const {
    const std::uint64_t most = max_steps.value_or(most_steps);
    return keep_proof ? std::min(most, most_steps) : most;
  }
};

} // namespace mdm
