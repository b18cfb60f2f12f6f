#pragma once
/// \file
/// The commands of `mdm`, one file each.

#include "cli/exit_code.hpp"

#include <CLI/CLI.hpp>

#include <functional>

namespace mdm::cli {

/// The work of a command once its arguments are parsed.
using Run = std::function<int()>;

/// Each adds its command with its options to `app` and returns what runs it.
Run add_solve(CLI::App &app);
Run add_batch(CLI::App &app);
Run add_blend(CLI::App &app);
Run add_convert(CLI::App &app);
Run add_describe(CLI::App &app);
Run add_export(CLI::App &app);
Run add_judge(CLI::App &app);
Run add_merge(CLI::App &app);
Run add_pack(CLI::App &app);
Run add_plot(CLI::App &app);
Run add_verify(CLI::App &app);
Run add_crosscheck(CLI::App &app);
Run add_report(CLI::App &app);
Run add_published(CLI::App &app);
Run add_generate(CLI::App &app);
Run add_study(CLI::App &app);
Run add_suite(CLI::App &app);
Run add_tradeoff(CLI::App &app);
/// \param app with all other commands
Run add_completion(CLI::App &app);

} // namespace mdm::cli
