#pragma once
/// \file
/// The Apollonian packings of mdm pack.

#include "cli/output_flags.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// What is asked about a gasket.
struct ApollonianFlags {
  std::optional<std::string> gasket, smallest;
  bool count_only = false;

  void add_to(CLI::App &command);
};

/// Counts, writes or describes a gasket. \param output its `-o` is for the packing, beside the report
int run_apollonian(const ApollonianFlags &flags, const OutputFlags &output);

} // namespace mdm::cli
