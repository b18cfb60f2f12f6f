#pragma once
/// \file
/// Deposits of discs: each in turn comes to rest on those before it.

#include "packing/disc_sizes.hpp"
#include "packing/packing.hpp"

#include <functional>
#include <optional>

namespace mdm {

/// How the lowest place is found; the places are the same.
enum class DepositSearch {
  blocks,   ///< by lower bounds of parts of the surface: some N log N
  full_walk ///< by a walk along all of the surface: some N sqrt(N)
};

/// What a deposit is to be.
struct DepositOptions {
  DepositRule rule = DepositRule::lowest;
  FloorRule floor = FloorRule::centred;
  bool periodic = true;
  std::optional<Rational> width; ///< of the box; open: about as wide as the deposit is high
  std::uint64_t seed = 1;        ///< of the order of discs, and of the columns of the rule drop
  bool shuffled = true;          ///< else the discs come in the order of `sizes`
  DepositSearch search = DepositSearch::blocks;
  std::function<void(std::size_t)> progress; ///< is told the number of discs that lie
};

/// Deposits discs in a random order. What a disc closes off stays closed. Every disc rests on two of the
/// earlier ones, the floor or the walls: it touches them but for some units of the lattice, which are some
/// 10^-12 of the smallest diameter, and its centre is above and between the two.
///
/// No two discs overlap, nor do the doubles that are nearest to the decimals of centres and radii: decided
/// for every disc in integers, with radii 2 units larger than written. Places are computed in doubles by + -
/// * / and square roots alone, and rounded to the lattice: they are the same on every machine.
///
/// \throws InputError before the work if there is no disc, the box is narrower than three of the largest
/// discs, or sizes are too far apart for the lattice
Packing deposit(const DiscSizes &sizes, const DepositOptions &options = {});

} // namespace mdm
