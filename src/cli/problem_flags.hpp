#pragma once
/// \file
/// The options of `mdm convert --problem`: the question about a gradation, for other solvers.

#include "ask/crosscheck_options.hpp"
#include "cli/output_flags.hpp"

namespace mdm::cli {

/// The language of a problem, and the question that it is of.
struct ProblemFlags {
  std::optional<std::string> language;
  CrosscheckTexts asked;

  void add_to(CLI::App &command);
  bool is_given() const { return language.has_value(); }
  /// \throws InputError where the other options say something else
  void check(const OutputFlags &output) const;
  /// The integer program of the question about g.
  std::string text(const Gradation &g) const;
};

} // namespace mdm::cli
