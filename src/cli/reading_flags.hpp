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

  /// The first of them that is given, such as `--sheet`; empty if there is none.
  std::string given() const;
  bool is_given() const { return !given().empty(); }
  /// True if none but --unit is given, or none.
  bool is_unit_at_most() const;
  /// All that are given as words of a command, for sh, with a space before each.
  std::string words() const;
};

} // namespace mdm::cli
