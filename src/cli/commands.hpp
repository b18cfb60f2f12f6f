#pragma once
/// \file
/// The commands of `mdm`, one file each.

#include <CLI/CLI.hpp>

#include <functional>

namespace mdm::cli {

/// Exit codes, the same for every command.
enum Exit : int {
  done = 0,      ///< done, accepted, matched
  negative = 1,  ///< a negative verdict, with its report
  bad_input = 2, ///< bad input or usage, or a file that cannot be read or written
  limited = 3    ///< a limit was reached; what is certain was reported
};

/// What a command does once its arguments are parsed.
using Run = std::function<int()>;

/// Each adds its command with its options to `app` and returns what runs it.
Run add_solve(CLI::App &app);
Run add_batch(CLI::App &app);
Run add_convert(CLI::App &app);
Run add_describe(CLI::App &app);
Run add_export(CLI::App &app);
Run add_plot(CLI::App &app);
Run add_verify(CLI::App &app);
Run add_crosscheck(CLI::App &app);
Run add_published(CLI::App &app);
Run add_generate(CLI::App &app);
Run add_study(CLI::App &app);
Run add_tradeoff(CLI::App &app);

} // namespace mdm::cli
