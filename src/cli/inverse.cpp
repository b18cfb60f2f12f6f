#include "cli/inverse.hpp"

#include "cli/exit_code.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "papers/inverse_report.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <memory>

namespace mdm::cli {

int run_inverse(const InverseTask &task, const OutputFlags &output, const AccessibleFlags &flags) {
  check_distinct({output.path(), flags.plot.path()});
  flags.plot.check();
  Output out(output.path());
  std::vector<InverseRow> rows(task.spans.size());
  {
    std::atomic<std::size_t> done = 0;
    const ProgressLine progress([&] { return fmt::format("{} of {} spans", done.load(), rows.size()); },
                                output.quiet);
    in_parallel(rows.size(), flags.threads, [&](std::size_t i) {
      rows[i] = {task.spans[i], inverse_shapes(task.at(task.spans[i]))};
      ++done;
    });
  }
  const std::unique_ptr<Output> plot =
      flags.plot ? flags.plot.drawn(inverse_map(task, rows), output.quiet) : nullptr;
  out.write(output.report([&] { return inverse_text(task, rows); }, [&] { return inverse_json(task, rows); },
                          [&] { return inverse_csv(rows); }));
  if (plot)
    plot->commit();
  out.commit();
  output.tell_notes_beside_csv(task.notes);
  if (std::any_of(rows.begin(), rows.end(), [](const InverseRow &row) { return !row.shapes.is_certain(); }))
    return Exit::limited;
  const bool found =
      std::any_of(rows.begin(), rows.end(), [](const InverseRow &row) { return !row.shapes.boxes.empty(); });
  return found ? Exit::done : Exit::negative;
}

} // namespace mdm::cli
