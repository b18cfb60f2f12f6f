#pragma once
/// \file
/// From a gradation and a question to the smallest match.

#include <mdm/match/limits.hpp>
#include <mdm/match/match.hpp>

#include <functional>

namespace mdm {

/// The choice of a scale in its window.
enum class ScaleChoice {
  automatic, ///< the asked volume where the window has it, else robust
  robust,    ///< near the geometric middle: sizes far from the sieves on both sides
  upper      ///< the window's upper end
};

/// The knowledge while a search goes on.
struct Progress {
  std::uint64_t steps = 0;          ///< of the sweep, or nodes of the tree, so far
  Integer lower_bound = 1;          ///< no match that the question allows has fewer particles
  std::optional<Integer> particles; ///< of the smallest match so far
};

/// Takes note of the progress; false: the search is to stop, as at a limit.
using ProgressCall = std::function<bool(const Progress &)>;

/// The way to solve and to show; nothing here changes what is proved.
struct SolveOptions {
  Limits limits;
  std::optional<Integer> at_most; ///< more particles than this are no match
  ScaleChoice scale = ScaleChoice::automatic;
  unsigned digits = 15; ///< significant digits of sizes
  /// Called ten times a second at most, and not at all by a search that ends sooner; by the thread that
  /// solves. After it has returned false it is not called again.
  ProgressCall progress;
};

/// Solves. Cost: the least match, one root a class, and nothing that depends on the size of N but its digits.
/// \throws InputError if the question does not fit the gradation
Match solve(Gradation g, const Question &question = {}, const SolveOptions &options = {});

} // namespace mdm
