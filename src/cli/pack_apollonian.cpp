#include "cli/pack_apollonian.hpp"

#include "cli/commands.hpp"
#include "files/output.hpp"
#include "files/progress_line.hpp"
#include "packing/packing_writer.hpp"
#include "report/apollonian_report.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <atomic>

namespace mdm::cli {

int run_apollonian(const PackTexts &asked, const OutputFlags &output) {
  if (!asked.smallest)
    throw InputError(option("apollonian") + ": circles without end: give the radius of the smallest by " +
                     option("smallest"));
  if (asked.count_only && output.out)
    throw InputError(option("count-only") + " writes no packing: leave it out, or -o");
  const ApollonianGasket g = asked.asked_gasket();
  const Rational smallest = asked.smallest_circle();
  const Rational most = 1 / smallest;
  std::atomic<std::uint64_t> counted = 0;
  const ProgressLine progress([&counted] { return fmt::format("counting, {} circles", counted.load()); },
                              output.quiet);
  const auto count = [&] { return g.census(most, [&counted](std::uint64_t n) { counted = n; }); };
  if (asked.count_only) {
    write_output("-", std::to_string(count().circles) + "\n");
    return Exit::done;
  }
  if (output.out) {
    const Packing packing = g.packing(most);
    Output file(*output.out);
    write_packing(packing, [&file](std::string_view text) { file.write(text); });
    file.commit();
    if (output.out == "-")
      return Exit::done;
  }
  if (output.is_csv()) {
    Output csv("-");
    apollonian_csv(*asked.gasket, g, most, [&csv](std::string_view text) { csv.write(text); });
    csv.commit();
    return Exit::done;
  }
  const ApollonianReport report{*asked.gasket, smallest, g, count()};
  write_output("-", output.is_json() ? apollonian_json(report) + "\n" : apollonian_text(report));
  return Exit::done;
}

} // namespace mdm::cli
