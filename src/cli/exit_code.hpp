#pragma once
/// \file
/// The exit codes.

#include "ask/outcome.hpp"

namespace mdm::cli {

/// Exit codes, the same for every command.
enum Exit : int {
  done = 0,      ///< done, accepted, matched
  negative = 1,  ///< a negative verdict, with its report
  bad_input = 2, ///< bad input or usage, or a file that cannot be read or written
  limited = 3    ///< a limit was reached; what is certain was reported
};

/// The exit code of a run over many is that of the worst: 2 before 3 before 1.
int worse_exit(int a, int b);

/// The exit code of a run that had no bad input.
Exit exit_code(Outcome outcome);

} // namespace mdm::cli
