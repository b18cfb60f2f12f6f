#pragma once
/// \file
/// What the user asks mdm export for.

#include "ask/export_options.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"

#include <vector>

namespace mdm::cli {

struct ExportCommand {
  ExportTexts own; ///< the options that no other command has
  SolveFlags flags;
  ReadingFlags reading;
  std::vector<CLI::Option *> solving; ///< options that only a gradation has a use for
  OutputFlags output;

  /// All of them as they were given.
  ExportTexts asked() const;
};

} // namespace mdm::cli
