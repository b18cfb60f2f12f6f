#pragma once
/// \file
/// The sizes of the discs that are to be packed.

#include <mdm/number/enclosure.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace mdm {

/// The most discs of a packing.
inline constexpr std::size_t most_discs = 10000000;

/// A diameter: digits * 10^-places.
struct DiscSize {
  std::uint64_t digits;
  unsigned places;

  bool operator==(const DiscSize &) const = default;
};

/// The diameters of discs, in any order.
struct DiscSizes {
  std::string unit; ///< empty: any
  std::vector<DiscSize> sizes;
  std::vector<std::string> notes = {}; ///< of the gradation that they match

  /// Adds the upper end of an enclosure, rounded up to 18 digits.
  /// \throws InputError if there are more than most_discs, or the size is 0 or beyond 10^18
  void add(const Enclosure &diameter, std::uint64_t count = 1);
  /// Half a diameter, rounded up to units of 10^-places. \throws InputError from 2^52 units on
  static std::int64_t radius(const DiscSize &diameter, unsigned places);
};

/// True for a text that begins as a file of sizes does.
bool has_disc_sizes(std::string_view text);

/// Reads the sizes that `mdm generate --sizes` writes: rows of `class,size_lo,size_hi`, the sizes with their
/// unit, or the JSON of a set of discs.
/// \throws InputError `file:line: what`
DiscSizes read_disc_sizes(std::string_view text, std::string_view file);

} // namespace mdm
