#pragma once
/// \file
/// `mdm generate --accessible`.

#include "cli/output_flags.hpp"
#include "papers/accessible_shapes.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// The options that only a grid of shapes has.
struct AccessibleFlags {
  bool on = false; ///< --accessible
  std::optional<std::string> a, b, plot;
  unsigned threads = 1;

  void add_to(CLI::App &command);
  /// True if one of them is given although a single set is asked for.
  bool needless() const { return !on && (a || b || plot || threads != 1); }
};

/// Numbers above 0 as `1,2,5` or `FROM:TO:STEP`, ascending, each once.
/// \throws InputError that names the option
std::vector<Rational> number_list(const std::string &name, const std::string &text);

/// Works out and reports the grid; returns the exit code: 3 if something was not decided.
int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags);

} // namespace mdm::cli
