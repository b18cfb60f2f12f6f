#pragma once
/// \file
/// The best blend in steps, or why there is none.

#include <mdm/blend/blend_problem.hpp>

#include <chrono>
#include <functional>

namespace mdm {

/// Shares with what they give.
struct Blend {
  std::vector<Rational> shares;  ///< of the mass, sum 1
  std::vector<Rational> passing; ///< percent, at each sieve of the problem
  Rational value;                ///< of the aim; 0 without one
};

/// The blend of any shares, within the limits or not.
Blend blend_of(const BlendProblem &problem, const std::vector<Rational> &shares);

/// The limits of sieves and shares that a blend does not keep, in the order of limits_of.
std::vector<BlendLimit> broken_limits(const BlendProblem &problem, const Blend &blend);

/// True where no more stockpiles have a share than the problem allows.
bool keeps_at_most(const BlendProblem &problem, const Blend &blend);

/// A multiple of a condition; of (shares sum to 1) of either sign.
struct BlendMultiple {
  BlendLimit limit;
  Rational multiplier;
};

/// Conditions that no shares meet together: the sum of the multiples has no positive coefficient of a share
/// on its left, and `excess` > 0 on its right (Farkas). The limits, without which there would be no
/// contradiction, are as few as can be: each subset of them can be met.
struct BlendContradiction {
  std::vector<BlendMultiple> limits; ///< multipliers > 0, of which the largest is 1
  Rational sum;                      ///< multiplier of (shares sum to 1)
  Rational excess;
};

/// A split of a search over the shares n_i / steps: n_i <= at in its first child, n_i > at in the next one.
struct BlendNode {
  std::size_t stockpile = 0;
  std::uint64_t at = 0;
  std::size_t first = 0; ///< number of the first child; 0: not split
};

/// When a search for blends is to end, and what it is to find.
struct BlendOptions {
  std::size_t best = 1;                 ///< so many of the best blends
  std::uint64_t node_limit = 1'000'000; ///< splits
  std::optional<std::chrono::steady_clock::time_point> deadline = std::nullopt;
  std::function<bool()> go_on = {};                  ///< asked from time to time; false ends the search
  std::optional<std::size_t> relaxed = std::nullopt; ///< where there is none, widen this sieve's limits alone
};

/// What is known of the best blends.
struct BlendAnswer {
  enum class Status {
    optimal,  ///< `best` are the best, in order
    feasible, ///< a limit came first: `best` is a blend, none has a value below `bound`
    none,     ///< there is none
    unknown   ///< a limit came before a blend was found
  };
  Status status = Status::unknown;
  /// Ascending by value; of equal values the one first whose first stockpile, then the second, and so on, has
  /// the smaller share.
  std::vector<Blend> best;
  bool is_all = false; ///< there are no blends besides
  Rational bound;      ///< no blend in steps has a lower value; where status is none: of no meaning
  std::uint64_t splits = 0;
  std::vector<BlendNode> tree; ///< of the search, until the best was found or excluded; the first is its root

  /// With any real shares, of any number of stockpiles: the best by the same order, if there is one.
  std::optional<Blend> real;
  /// Prices: so much does the value change at most a unit of room at the limit, near the real optimum; less
  /// where other limits hold it, too. The sum of all, each times its limit, is the value.
  std::vector<BlendMultiple> prices;
  /// The real optimum in steps, rounded by largest remainders, and what it breaks.
  std::optional<Blend> rounded;

  /// Why no real shares will do.
  std::optional<BlendContradiction> contradiction;
  /// Blends for which the limits are widened least, by their value: with real shares, and in steps. Nothing
  /// where no widening helps, or a limit came first.
  std::optional<Blend> widened_real, widened;
  bool is_widening_decided = false; ///< no limit came before these two
};

/// Finds the best blends.
/// Cost: for some stockpiles and sieves milliseconds; the search may take exponential time.
/// \throws InputError if the problem is none
BlendAnswer solve_blend(const BlendProblem &problem, const BlendOptions &options = {});

} // namespace mdm
