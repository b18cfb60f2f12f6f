#pragma once
/// \file
/// The options of what soil mechanics says of a gradation.

#include "ask/soil_options.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// The options of describe and of plot, which shows the same numbers.
struct SoilFlags : SoilTexts {
  void add_to(CLI::App &command);
};

} // namespace mdm::cli
