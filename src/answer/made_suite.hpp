#pragma once
/// \file
/// Which suite lines are of that mdm suite made, and which part of it: the JSON before the lines of a shard.

#include "text/json_writer.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>

namespace mdm {

/// The lines `from` to `to` that a description and a seed make. They depend on these alone.
struct MadeSuite {
  std::string description; ///< SHA-256 of the description, in hexadecimal digits
  std::uint64_t seed = 1;
  std::uint64_t from = 1, to = 0;
  bool operator==(const MadeSuite &) const = default;
};

void write_made_suite(JsonWriter &json, const MadeSuite &suite);
/// \throws InputError if it is none
MadeSuite made_suite_of(const nlohmann::json &json);

/// The shard `shard` of `shards` of such a suite.
struct MadeShard {
  MadeSuite suite;
  std::uint64_t shard = 1, shards = 1;
  std::uint64_t lines = 0; ///< that follow
};

/// The format of the line that precedes those of a shard.
inline constexpr std::string_view made_shard_schema = "mdm-shard-1";

/// One line, without its end.
std::string made_shard_json(const MadeShard &shard);
/// True of a line that made_shard_json may have written.
bool begins_made_shard(std::string_view line);
/// Reads what made_shard_json wrote. \throws InputError if it is not that
MadeShard read_made_shard(std::string_view line);

} // namespace mdm
