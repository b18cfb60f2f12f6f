#pragma once
/// \file
/// mdm crosscheck of problems of blends.

#include "cli/output_flags.hpp"
#include "files/file_lines.hpp"

#include <chrono>

namespace mdm::cli {

/// What is asked about blends of another solver.
struct CrosscheckBlends {
  std::string suite;
  std::optional<std::string> answers, solver; ///< one of them
  std::chrono::milliseconds time_limit;       ///< of the solver
  unsigned threads = 1;
  bool require_best = false; ///< a blend within the limits is not enough
  const OutputFlags &output;
};

/// Judges the answers to the problems in these lines. \return the exit code
/// \throws InputError naming a line that is no problem
int crosscheck_blends(FileLines &lines, const CrosscheckBlends &c);

} // namespace mdm::cli
