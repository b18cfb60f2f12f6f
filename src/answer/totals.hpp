#pragma once
/// \file
/// What a shard of a batch, or a whole set of shards, holds: the JSON of FILE.totals.

#include "answer/line_sum.hpp"
#include "answer/made_suite.hpp"

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// The bytes of a file, as they lie on the disk.
struct FileTotals {
  std::uint64_t bytes = 0;
  std::string sha256; ///< in hexadecimal digits
  bool operator==(const FileTotals &) const = default;
};

/// A whole suite, as it was read.
struct SuiteTotals : FileTotals {
  LineSum sum; ///< of its lines that are not blank
  bool operator==(const SuiteTotals &) const = default;
};

/// A file beside the totals.
struct NamedFileTotals : FileTotals {
  std::string name; ///< from the folder of the totals
};

/// Totals of the shard `shard` of `shards`; of a whole set both are 1.
struct Totals {
  std::uint64_t shard = 1, shards = 1;
  std::string question;             ///< the options that were given, as words
  std::optional<SuiteTotals> suite; ///< nothing where no run read all of it
  std::optional<MadeSuite> made;    ///< of lines that came alone and said so: their suite
  std::optional<FileTotals> alone;  ///< a file that has the lines of the shard alone
  LineSum sum;                      ///< of the lines that were answered
  std::uint64_t lines = 0;          ///< of the answers
  std::uint64_t errors = 0;         ///< of them
  int exit = 0;                     ///< that of the worst line
  NamedFileTotals answers;
  std::optional<NamedFileTotals> proofs, index; ///< both or none
  std::map<std::string, std::string> versions;  ///< of the program and its libraries
};

/// The format of FILE.totals.
inline constexpr std::string_view totals_schema = "mdm-totals-1";

/// One line, without its end.
std::string totals_json(const Totals &totals);

/// Reads what totals_json wrote.
/// \param name precedes the messages
/// \throws InputError if it is not that
Totals read_totals(std::string_view text, std::string_view name);

} // namespace mdm
