#include "cli/accessible.hpp"

#include "ask/generate.hpp"
#include "cli/commands.hpp"
#include "cli/whole_number.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/standard_streams.hpp"
#include "papers/accessible_report.hpp"

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {

void AccessibleFlags::add_to(CLI::App &command) {
  plot.add_to(command, "the map of --accessible, --cu or --fit");
  command.add_option("-j", threads, "threads of --accessible, --cu or --fit")
      ->type_name("THREADS")
      ->transform(whole_number(1, 1024));
}

int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags) {
  check_distinct({output.path(), flags.plot.path()});
  flags.plot.check();
  std::vector<AccessibleRow> rows = accessible_grid(question);
  Output out(output.path());
  std::atomic<std::size_t> done = 0;
  {
    const ProgressLine progress([&] { return fmt::format("{} of {} shapes", done.load(), rows.size()); },
                                output.quiet);
    in_parallel(rows.size(), flags.threads, [&](std::size_t i) {
      fill(rows[i], question);
      ++done;
    });
  }
  const std::unique_ptr<Output> plot =
      flags.plot ? flags.plot.drawn(accessible_map(question, rows), output.quiet) : nullptr;
  out.write(output.report([&] { return accessible_text(question, rows); },
                          [&] { return accessible_json(question, rows); },
                          [&] { return accessible_csv(rows); }));
  if (plot)
    plot->commit();
  out.commit();
  const std::vector<std::string> open = undecided(rows);
  // CSV has no place for them.
  if (output.is_csv())
    for (const std::string &line : open)
      tell(line + "\n");
  return open.empty() ? Exit::done : Exit::limited;
}

} // namespace mdm::cli
