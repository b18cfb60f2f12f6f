#pragma once
/// \file
/// A packing of discs: centres and radii on an integer lattice.

#include <mdm/number/rational.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace mdm {

/// Where the next disc of a deposit goes.
enum class DepositRule {
  lowest,    ///< to the lowest place that can be reached from above (Voivret, Delenne, Radjai)
  drop,      ///< down in a random column, then rolling to rest (Visscher, Bolsterli 1972)
  apollonian ///< no deposit: circles of a gasket
};

/// Where a disc goes that finds a piece of the floor bare.
enum class FloorRule {
  left,   ///< to the left end of the piece
  centred ///< to its middle
};

/// What carries a disc on one of its sides, where that is no disc.
enum Support : std::int32_t { on_floor = -1, on_left_wall = -2, on_right_wall = -3, unsupported = -4 };

/// A disc; lengths in units of the packing.
struct PackedDisc {
  std::int64_t x, y, r;
  std::int32_t left, right; ///< an earlier disc, counted from 0, or a Support

  bool operator==(const PackedDisc &) const = default;
};

/// A rectangle, in units of a packing.
struct PackingWindow {
  std::int64_t x_min, y_min, x_max, y_max;

  bool operator==(const PackingWindow &) const = default;
  bool is_empty() const { return x_min >= x_max || y_min >= y_max; }
};

/// Discs that do not overlap, on the floor y = 0, between the walls x = 0 and x = width or repeated by that
/// width. All lengths are integers in units of 10^-places and below 2^52, so that they are doubles too.
struct Packing {
  std::string unit; ///< of lengths; empty: any
  unsigned places = 0;
  std::int64_t width = 0;
  bool periodic = true;
  DepositRule rule = DepositRule::lowest;
  FloorRule floor = FloorRule::centred;
  std::uint64_t seed = 0;
  std::int64_t front = 0;        ///< height of the lowest centre among the discs that nothing covers
  std::vector<PackedDisc> discs; ///< in the order of their deposit

  std::int64_t largest_radius() const;
  /// Where the deposit is undisturbed: two largest diameters from the floor and from walls, one below the
  /// front.
  PackingWindow inner_window() const;
  /// A length as a decimal.
  std::string text(std::int64_t length) const;
  /// A fingerprint of the radii in any order: FNV-1a, 64 bits, of the sorted radii as lines of decimals.
  std::string radii_hash() const;

  bool operator==(const Packing &) const = default;
};

} // namespace mdm
