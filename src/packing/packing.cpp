#include "packing/packing.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

std::int64_t Packing::largest_radius() const {
  std::int64_t largest = 0;
  for (const PackedDisc &d : discs)
    largest = std::max(largest, d.r);
  return largest;
}

PackingWindow Packing::inner_window() const {
  const std::int64_t diameter = 2 * largest_radius();
  const std::int64_t aside = periodic ? 0 : 2 * diameter;
  return {aside, 2 * diameter, width - aside, front - diameter};
}

std::string Packing::text(std::int64_t length) const {
  return length < 0 ? "-" + decimal_string(Integer(-length), places)
                    : decimal_string(Integer(length), places);
}

std::string Packing::radii_hash() const {
  std::vector<std::int64_t> radii;
  radii.reserve(discs.size());
  for (const PackedDisc &d : discs)
    radii.push_back(d.r);
  std::sort(radii.begin(), radii.end());
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::int64_t r : radii)
    for (const char c : fmt::format("{}\n", r))
      hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return fmt::format("{:016x}", hash);
}

} // namespace mdm
