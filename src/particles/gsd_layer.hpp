#pragma once
/// \file
/// The file layer of GSD 2.0: a header, names, and an index of chunks of numbers, all little-endian.

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace mdm::gsd {

inline constexpr std::uint64_t magic = 0x65DF65DF65DF65DF;
inline constexpr std::uint32_t version_1 = 0x00010000, version_2 = 0x00020000;
inline constexpr const char *hoomd = "hoomd"; ///< the schema
inline constexpr std::uint32_t hoomd_schema = 0x00010004;
inline constexpr std::size_t name_bytes = 64; ///< of the namelist, for each allocated entry

struct Header {
  std::uint64_t magic = gsd::magic;
  std::uint64_t index_location = 0, index_entries = 0;
  std::uint64_t names_location = 0, names_entries = 0;
  std::uint32_t schema_version = hoomd_schema, version = version_2;
  std::array<char, 64> application{}, schema{};
  std::array<char, 80> reserved{};
};
static_assert(sizeof(Header) == 256);

/// Types of numbers.
enum class Type : std::uint8_t { uint8 = 1, uint32 = 3, uint64 = 4, int8 = 5, float32 = 9 };

/// A chunk of rows by columns numbers. Where the location is 0, the index ends.
struct Entry {
  std::uint64_t frame = 0, rows = 0;
  std::int64_t location = 0;
  std::uint32_t columns = 0;
  std::uint16_t name = 0;
  std::uint8_t type = 0, flags = 0;
};
static_assert(sizeof(Entry) == 32);

inline constexpr const char *step_name = "configuration/step", *box_name = "configuration/box",
                            *count_name = "particles/N", *types_name = "particles/types",
                            *type_name = "particles/typeid", *mass_name = "particles/mass",
                            *diameter_name = "particles/diameter", *position_name = "particles/position";

} // namespace mdm::gsd
