#pragma once
/// \file
/// `mdm generate --accessible`.

#include "cli/output_flags.hpp"
#include "cli/plot_flag.hpp"
#include "papers/accessible_shapes.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// How shapes are worked out and drawn.
struct AccessibleFlags {
  PlotFlag plot;
  unsigned threads = 1;

  void add_to(CLI::App &command);
  bool is_given() const { return plot || threads != 1; }
};

/// Works out and reports the grid; returns the exit code: 3 if something was not decided.
int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags);

} // namespace mdm::cli
