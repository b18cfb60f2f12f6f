#include "cli/pack_apollonian.hpp"

#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/progress.hpp"
#include "files/output.hpp"
#include "number/typed_number.hpp"
#include "packing/packing_writer.hpp"
#include "report/apollonian_report.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <array>
#include <atomic>

namespace mdm::cli {
namespace {

/// A whole number with its sign.
Integer whole(const std::string &text) {
  const bool negative = !text.empty() && text.front() == '-';
  const std::optional<Integer> n = parse_typed_natural(negative ? std::string_view(text).substr(1) : text);
  if (!n)
    throw InputError("--apollonian: " + in_quotes(text) +
                     " is no whole number: write equal, or for example -1,2,2,3");
  return negative ? Integer(-*n) : *n;
}

ApollonianGasket gasket(const std::string &text) {
  if (text == "equal")
    return ApollonianGasket::equal();
  std::array<Integer, 4> w;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const std::size_t end = i + 1 < w.size() ? text.find(',', begin) : text.size();
    if (end == std::string::npos)
      throw InputError("--apollonian: " + in_quotes(text) +
                       " is not four curvatures: write equal, or for example "
                       "-1,2,2,3");
    w.at(i) = whole(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return named("apollonian", text, [&w](const std::string &) { return ApollonianGasket::integral(w); });
}

/// `0.001` or `1/1000`.
Rational radius(const std::string &text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string::npos)
    return positive("smallest", text);
  return positive("smallest", text.substr(0, slash)) / positive("smallest", text.substr(slash + 1));
}

void print(const std::string &text) {
  Output out("-");
  out.write(text);
  out.commit();
}

} // namespace

void ApollonianFlags::add_to(CLI::App &command) {
  command
      .add_option(
          "--apollonian", gasket,
          "no deposit: the Apollonian packing around three circles of radius 1 (equal), or of the four "
          "whole curvatures, the outer circle's below 0")
      ->type_name("equal|A,B,C,D");
  command
      .add_option("--smallest", smallest,
                  "radius of the smallest circles of an Apollonian packing, as 0.001 or "
                  "1/1000; the outer circle is not counted")
      ->type_name("R");
  command.add_flag("--count-only", count_only, "of an Apollonian packing: the number of circles alone");
}

int run_apollonian(const ApollonianFlags &flags, const OutputFlags &output) {
  if (!flags.smallest)
    throw InputError("--apollonian: circles without end: give the radius of the smallest by --smallest");
  if (flags.count_only && output.out)
    throw InputError("--count-only writes no packing: leave it out, or -o");
  const ApollonianGasket g = gasket(*flags.gasket);
  const Rational smallest = radius(*flags.smallest);
  const Rational most = 1 / smallest;
  std::atomic<std::uint64_t> counted = 0;
  const Progress progress([&counted] { return fmt::format("counting, {} circles", counted.load()); },
                          output.quiet);
  const auto count = [&] { return g.census(most, [&counted](std::uint64_t n) { counted = n; }); };
  if (flags.count_only) {
    print(std::to_string(count().circles) + "\n");
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
    apollonian_csv(*flags.gasket, g, most, [&csv](std::string_view text) { csv.write(text); });
    csv.commit();
    return Exit::done;
  }
  const ApollonianReport report{*flags.gasket, smallest, g, count()};
  print(output.is_json() ? apollonian_json(report) + "\n" : apollonian_text(report));
  return Exit::done;
}

} // namespace mdm::cli
