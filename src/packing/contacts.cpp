// Which discs touch. What comes in is a packing and a tolerance in units; what goes out are the pairs whose
// gap is from 0 to the tolerance, the pairs that overlap, and the largest gap of the ones and the smallest
// of the others.
//
// A grid of cells for each octave of radii hands on all pairs that are near enough. A pair is decided by
// comparing d^2 with (r + r')^2 and (r + r' + tolerance)^2 in 128-bit integers; the gap itself is enclosed
// to thousandths of a unit by an integer root.

#include "packing/contacts.hpp"

#include "packing/disc_grid.hpp"
#include "packing/wide.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

using packing::Wide;

/// Gaps are enclosed in thousandths of a unit.
constexpr std::int64_t parts = 1000;

/// Largest integer y with y^2 <= n, for n >= 0.
Wide floor_sqrt(Wide n) {
  auto y = static_cast<Wide>(std::sqrt(static_cast<double>(n)));
  if (y > 0)
    y = (y + n / y) / 2;
  while (y * y > n)
    --y;
  while ((y + 1) * (y + 1) <= n)
    ++y;
  return y;
}

/// The gap of two discs whose centres are at that distance squared, in parts of a unit, rounded down.
std::int64_t gap(Wide distance2, Wide sum) {
  return static_cast<std::int64_t>(floor_sqrt(distance2 * parts * parts) - sum * parts);
}

Interval enclosed(std::int64_t gap) {
  return {ratio(gap, parts), ratio(gap + 1, parts)};
}

} // namespace

PackingContacts packing_contacts(const Packing &p, std::int64_t tolerance) {
  PackingContacts c;
  c.tolerance = tolerance;
  c.of_disc.resize(p.discs.size());
  if (p.discs.empty())
    return c;
  std::int64_t smallest = p.discs.front().r;
  for (const PackedDisc &d : p.discs) {
    smallest = std::min(smallest, d.r);
    if (d.y - d.r <= tolerance)
      ++c.on_floor;
    if (!p.periodic && d.x - d.r <= tolerance)
      ++c.on_walls;
    if (!p.periodic && p.width - d.x - d.r <= tolerance)
      ++c.on_walls;
  }
  const std::int64_t reach = std::max(tolerance, smallest / 4);
  const packing::DiscGrid grid(p);
  std::optional<std::int64_t> largest, smallest_other;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(p.discs.size()); ++i)
    grid.each_pair_of(i, reach, [&](std::int32_t j, std::int64_t dx, std::int64_t dy) {
      const Wide sum = p.discs[static_cast<std::size_t>(i)].r + p.discs[static_cast<std::size_t>(j)].r;
      const Wide distance2 = Wide{dx} * dx + Wide{dy} * dy;
      if (distance2 > (sum + reach) * (sum + reach))
        return;
      if (distance2 < sum * sum) {
        ++c.overlaps;
        if (!c.first_overlap)
          c.first_overlap = std::minmax(i, j);
        return;
      }
      const std::int64_t g = gap(distance2, sum);
      if (distance2 <= (sum + tolerance) * (sum + tolerance)) {
        c.pairs.push_back({i, j, dx, dy});
        ++c.of_disc[static_cast<std::size_t>(i)];
        ++c.of_disc[static_cast<std::size_t>(j)];
        largest = std::max(largest.value_or(g), g);
      } else {
        smallest_other = std::min(smallest_other.value_or(g), g);
      }
    });
  if (largest)
    c.largest_gap = enclosed(*largest);
  if (smallest_other)
    c.smallest_other_gap = enclosed(*smallest_other);
  return c;
}

} // namespace mdm
