#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/soil_flags.hpp"
#include "cli/whole_number.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/standard_streams.hpp"
#include "report/description.hpp"

#include <memory>

namespace mdm::cli {
namespace {

struct DescribeCommand {
  std::string file;
  SoilFlags soil;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  OutputFlags output;
};

std::string report(const DescribeCommand &c, const SoilDescription &d) {
  constexpr unsigned exchanged = 15, read = 4;
  return c.output.report([&] { return description_text(d, c.digits.value_or(read)); },
                         [&] { return description_json(d, c.digits.value_or(exchanged)); },
                         [&] { return description_csv(d, c.digits.value_or(exchanged)); });
}

int run(const DescribeCommand &c) {
  check_distinct({c.file, c.output.path()});
  const DescribeOptions o = c.soil.describe_options();
  const Gradation g = any_gradation(c.file, c.reading, c.output.quiet).gradation;
  const SoilDescription d = describe(in_file(c.file, [&] { return c.soil.with_pan(g); }), o);
  Output out(c.output.path());
  out.write(report(c, d));
  out.commit();
  return exit_code(outcome_of(d));
}

} // namespace

Run add_describe(CLI::App &app) {
  const auto c = std::make_shared<DescribeCommand>();
  CLI::App &command =
      *app.add_subcommand("describe", "Index numbers, fractions and the soil group of a gradation");
  command
      .add_option("FILE", c->file,
                  "gradation (any that mdm convert reads), set of mdm generate, or file of particles as mdm "
                  "verify reads; - for "
                  "standard input")
      ->required();
  c->soil.add_to(command);
  command.add_option("--digits", c->digits, "significant digits (15; in the text form 4)")
      ->type_name("D")
      ->transform(whole_number(1, 1000));
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "C_u = D60 / D10 and C_c = D30^2 / (D10 D60) are of ASTM D2487. I_GS is the grain size index of "
          "Erguler (2016), I_C Arnold's index of curvature, phi_1 the mass of the finest class over that of "
          "the coarsest, zeta_1 the volume of the coarsest class's largest particle over that of the "
          "finest's (Arnold, Eq. 15 and 16).") +
          "\n" +
          paragraph(
              "Exit code 3: the group hangs on an interpolated share or an index that 1,200 digits do not "
              "tell from its limit; the report says which."),
      {"mdm describe sand.csv", "mdm describe sand.csv --liquid-limit 30 --plastic-limit 22",
       "mdm describe report.ags --specimen-id BH1 --format json -o bh1.json"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
