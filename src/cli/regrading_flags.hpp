#pragma once
/// \file
/// The options that make one gradation of several, or change one.

#include "ask/regrading.hpp"
#include "cli/reading_flags.hpp"

namespace mdm::cli {

struct RegradingFlags : RegradingTexts {
  void add_to(CLI::App &command);
  /// The files joined. \pre there are two
  Regraded joined_files(const ReadingFlags &reading, bool quiet) const;
};

} // namespace mdm::cli
