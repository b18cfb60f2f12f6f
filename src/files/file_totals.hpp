#pragma once
/// \file
/// The totals of files as they lie on the disk.

#include "answer/totals.hpp"

#include <optional>
#include <string>

namespace mdm {

/// A file, and what its totals say of it.
struct PartFile {
  std::string path;
  FileTotals totals;
};

/// Refuses a file that is not as long as its totals say, before any work is done. \throws InputError
void check_bytes(const PartFile &file);

/// Those of a regular file; nothing of others. \throws InputError if it cannot be read
std::optional<FileTotals> file_totals(const std::string &path);

/// The suite in a file, as a shard that is not alone tells it. \throws InputError if it cannot be read
SuiteTotals suite_totals(const std::string &path);

} // namespace mdm
