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
#include "report/sediment_report.hpp"
#include "text/option_name.hpp"

#include <memory>

namespace mdm::cli {
namespace {

struct DescribeCommand {
  std::string file;
  SoilFlags soil;
  bool sediment = false;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  OutputFlags output;
};

/// The report in the form that was asked for.
template <class Description>
std::string report(const DescribeCommand &c, const Description &d,
                   std::string (&text)(const Description &, unsigned),
                   std::string (&json)(const Description &, unsigned),
                   std::string (&csv)(const Description &, unsigned)) {
  constexpr unsigned exchanged = 15, read = 4;
  return c.output.report([&] { return text(d, c.digits.value_or(read)); },
                         [&] { return json(d, c.digits.value_or(exchanged)); },
                         [&] { return csv(d, c.digits.value_or(exchanged)); });
}

void write(const DescribeCommand &c, const std::string &text) {
  Output out(c.output.path());
  out.write(text);
  out.commit();
}

/// The gradation, with the pan that was asked for.
Gradation gradation(const DescribeCommand &c) {
  const Gradation g = any_gradation(c.file, c.reading, c.output.quiet).gradation;
  return in_file(c.file, [&] { return c.soil.with_pan(g); });
}

int describe_as_sediment(const DescribeCommand &c) {
  if (c.soil.liquid_limit || c.soil.plastic_limit)
    throw InputError(option("sediment") + " has no use for Atterberg limits: leave them out");
  const SedimentDescription s = describe_sediment(gradation(c), c.soil.extrapolate);
  write(c, report(c, s, sediment_text, sediment_json, sediment_csv));
  return s.limited() ? Exit::limited : Exit::done;
}

int run(const DescribeCommand &c) {
  check_distinct({c.file, c.output.path()});
  if (c.sediment)
    return describe_as_sediment(c);
  const DescribeOptions o = c.soil.describe_options();
  const SoilDescription d = describe(gradation(c), o);
  write(c, report(c, d, description_text, description_json, description_csv));
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
  command.add_flag("--sediment", c->sediment,
                   "as sedimentology has it: Folk and Ward, moments, Trask, modes, texture, Wentworth");
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
              "--sediment: mean, sorting, skewness and kurtosis on the phi scale, after Folk and Ward (1957) "
              "and as moments of the classes' middles, with their words, decided at their limits; the "
              "texture "
              "is of Folk (1954).") +
          "\n" +
          paragraph(
              "Exit code 3: the group hangs on an interpolated share or an index that 1,200 digits do not "
              "tell from its limit; the report says which."),
      {"mdm describe sand.csv", "mdm describe sand.csv --sediment",
       "mdm describe sand.csv --liquid-limit 30 --plastic-limit 22",
       "mdm describe report.ags --specimen-id BH1 --format json -o bh1.json"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
