#pragma once
/// \file
/// `mdm generate --accessible`.

#include "cli/output_flags.hpp"
#include "papers/accessible_shapes.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// How a grid of shapes is worked out and drawn.
struct AccessibleFlags {
  std::optional<std::string> plot;
  unsigned threads = 1;

  void add_to(CLI::App &command);
  bool is_given() const { return plot || threads != 1; }
};

/// Works out and reports the grid; returns the exit code: 3 if something was not decided.
int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags);

} // namespace mdm::cli
