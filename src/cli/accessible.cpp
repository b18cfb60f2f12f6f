#include "cli/accessible.hpp"

#include "ask/generate.hpp"
#include "cli/commands.hpp"
#include "cli/picture.hpp"
#include "cli/progress.hpp"
#include "cli/whole_number.hpp"
#include "files/in_parallel.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "papers/accessible_report.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <memory>

namespace mdm::cli {
void AccessibleFlags::add_to(CLI::App &command) {
  command.add_option("--plot", plot, "the map of --accessible, --cu or --fit into OUT.svg, .png or .pdf")
      ->type_name("OUT");
  command.add_option("-j", threads, "threads of --accessible, --cu or --fit")
      ->type_name("THREADS")
      ->transform(whole_number(1, 1024));
}

std::optional<Picture> AccessibleFlags::picture() const {
  if (plot == "-")
    throw InputError(option("plot") + " needs a file: standard output has the answer");
  const std::optional<Picture> asked = plot ? picture_at(*plot) : std::nullopt;
  if (plot && !asked)
    throw InputError(option("plot") + ": " + printable(*plot) + ": let OUT end in .svg, .png or .pdf");
  return asked;
}

int run_accessible(const AccessibleQuestion &question, const OutputFlags &output,
                   const AccessibleFlags &flags) {
  const std::optional<Picture> picture = flags.picture();
  check_distinct({output.path(), flags.plot.value_or("-")});
  std::vector<AccessibleRow> rows = accessible_grid(question);
  Output out(output.path());
  std::atomic<std::size_t> done = 0;
  {
    const Progress progress([&] { return fmt::format("{} of {} shapes", done.load(), rows.size()); },
                            output.quiet);
    in_parallel(rows.size(), flags.threads, [&](std::size_t i) {
      fill(rows[i], question);
      ++done;
    });
  }
  std::unique_ptr<Output> plot;
  if (picture) {
    plot = std::make_unique<Output>(*flags.plot);
    plot->write(picture_of(accessible_map(question, rows), *picture));
  }
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
