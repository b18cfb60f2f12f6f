#pragma once
/// \file
/// The Apollonian packings of mdm pack.

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

/// Counts, writes or describes a gasket. \param out empty: no packing file
int run_apollonian(const ApollonianFlags &flags, const std::string &format, const std::string &out,
                   bool quiet);

} // namespace mdm::cli
