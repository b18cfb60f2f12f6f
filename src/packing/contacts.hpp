#pragma once
/// \file
/// Which discs of a packing touch.

#include "packing/packing.hpp"

#include <mdm/number/interval.hpp>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace mdm {

/// Two discs that touch.
struct DiscContact {
  std::int32_t a, b;   ///< numbers of the discs
  std::int64_t dx, dy; ///< from the centre of a to that of b, or to its image that is touched
};

/// The contacts of a packing, decided in integers: discs touch whose gap is up to the tolerance.
struct PackingContacts {
  std::int64_t tolerance = 0; ///< in units of the packing, as all lengths
  std::vector<DiscContact> pairs;
  std::uint64_t on_floor = 0, on_walls = 0;
  std::vector<std::uint32_t> of_disc; ///< contacts with other discs
  std::uint64_t overlaps = 0;         ///< pairs whose gap is below 0; they are no contacts
  std::optional<std::pair<std::int32_t, std::int32_t>> first_overlap;
  std::optional<Interval> largest_gap; ///< of a contact of two discs
  /// The smallest gap of two discs that do not touch, if it is up to a quarter of the smallest radius.
  std::optional<Interval> smallest_other_gap;
};

/// What is called a contact in a deposit: its discs are laid some 8 units from each other, and other gaps are
/// larger by orders of magnitude, but among equal discs.
inline constexpr std::int64_t usual_contact_tolerance = 64;

/// Cost: some us a disc.
PackingContacts packing_contacts(const Packing &packing, std::int64_t tolerance = usual_contact_tolerance);

/// A disc at a corner of a cell.
struct CellCorner {
  std::int32_t disc;
  std::int64_t x, y; ///< of the centre; continued beyond the period
};

/// Hands on the cells of the contact graph, the least polygons of discs that touch one after the other,
/// counterclockwise. What is open to the floor, to a wall or above is none.
void each_cell(const Packing &packing, const PackingContacts &contacts,
               const std::function<void(const std::vector<CellCorner> &)> &take);

} // namespace mdm
