#pragma once
/// \file
/// The options of what soil mechanics says of a gradation.

#include "ask/soil_options.hpp"

#include <CLI/CLI.hpp>

namespace mdm::cli {

/// The options of describe and of plot, which shows the same numbers.
struct SoilFlags : SoilTexts {
  void add_to(CLI::App &command);

  /// True if one of them is given.
  bool is_given() const { return liquid_limit || plastic_limit || pan_size || extrapolate; }
};

} // namespace mdm::cli
