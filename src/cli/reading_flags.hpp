#pragma once
/// \file
/// The options that say how a gradation file is to be read.

#include "ask/reading_options.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace mdm::cli {

/// The options of reading, for every command that reads a gradation.
struct ReadingFlags : ReadingTexts {
  /// Adds them in a group of their own, after all other options: of a command that has one of the names for
  /// something else, that one is left out.
  /// \return the options that were added
  std::vector<CLI::Option *> add_to(CLI::App &command);
};

} // namespace mdm::cli
