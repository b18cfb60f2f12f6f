#pragma once
/// \file
/// The options of solving, shared by the commands that solve.

#include <mdm/match/solve.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// What the user wrote, as text: numbers are read exactly, never through double.
struct SolveFlags {
  using Text = std::optional<std::string>;
  Text min_per_class, at_least, at_most;
  Text specimen, void_ratio, solids_volume;
  Text law, size_factor, cut_below, pan_size;
  Text digits, scale;
  Text max_steps, node_limit, time_limit;

  void add_to(CLI::App &command);

  /// \throws InputError naming the option where its value does not serve
  Question question() const;
  /// The deadline counts from this call.
  SolveOptions options() const;
};

} // namespace mdm::cli
