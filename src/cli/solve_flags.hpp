#pragma once
/// \file
/// The options of solving, and those of them that more commands share.

#include "cli/asked_question.hpp"

#include <mdm/match/solve.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// The options that say how a gradation is to be taken, for every command that weighs particles. Values are
/// kept as the user wrote them: numbers are read exactly, never through double.
struct GradationFlags {
  using Text = std::optional<std::string>;
  Text law, size_factor, cut_below, pan_size;

  void add_to(CLI::App &command);

  /// \throws InputError naming the option where its value does not serve
  AskedQuestion question() const;
};

/// All options of solving.
struct SolveFlags : GradationFlags {
  std::vector<std::string> tolerances;
  Text band;
  Text min_per_class, at_least, at_most;
  Text specimen, void_ratio, solids_volume;
  Text digits, scale;
  Text max_steps, node_limit, time_limit, gap;

  void add_to(CLI::App &command);
  /// Without those that only change the sizes of an answer.
  void add_problem(CLI::App &command);

  bool is_tolerant() const { return !tolerances.empty() || band; }
  /// The source of the gradation: FILE, or else the band alone.
  const std::string &source(const Text &file) const { return file ? *file : *band; }
  /// \param reading an option of reading that is given, or an empty text
  /// \throws InputError if there is neither, or if they do not go together
  void check_source(const Text &file, const std::string &reading, const std::string &command) const;
  /// \throws InputError naming the option where its value does not serve
  AskedQuestion question() const;
  /// The same for a command that looks for exact matches and for those within a tolerance: limits of either
  /// serve.
  AskedQuestion question_of_both() const;
  /// The deadline counts from this call.
  SolveOptions options(bool keep_proof = false) const;

private:
  void add_question(CLI::App &command);
  void add_limits(CLI::App &command);
};

} // namespace mdm::cli
