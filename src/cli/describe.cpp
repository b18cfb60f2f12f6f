#include "cli/commands.hpp"
#include "cli/files.hpp"
#include "cli/help.hpp"
#include "cli/option_values.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "report/description.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct DescribeCommand {
  std::string file;
  std::optional<std::string> liquid_limit, plastic_limit, pan_size;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  bool extrapolate = false;
  OutputFlags output;
};

Rational number(const char *option, const std::string &text) {
  return named(option, text, [](const std::string &t) { return parse_decimal(t); });
}

DescribeOptions options(const DescribeCommand &c) {
  if (c.liquid_limit.has_value() != c.plastic_limit.has_value())
    throw InputError("--liquid-limit and --plastic-limit go together: give both, or neither for silt");
  DescribeOptions o;
  o.extrapolate = c.extrapolate;
  if (c.liquid_limit) {
    o.limits = AtterbergLimits{number("--liquid-limit", *c.liquid_limit),
                               number("--plastic-limit", *c.plastic_limit)};
    classify_fines(*o.limits);
  }
  return o;
}

Gradation gradation(const DescribeCommand &c) {
  Gradation g = any_gradation(c.file, c.reading, c.output.quiet).gradation;
  if (!c.pan_size)
    return g;
  const Rational size = length("--pan-size", *c.pan_size).in(g.unit());
  return in_file(c.file, [&] { return g.with_pan_size(size); });
}

std::string report(const DescribeCommand &c, const SoilDescription &d) {
  constexpr unsigned exchanged = 15, read = 4;
  return c.output.report([&] { return description_text(d, c.digits.value_or(read)); },
                         [&] { return description_json(d, c.digits.value_or(exchanged)); },
                         [&] { return description_csv(d, c.digits.value_or(exchanged)); });
}

int run(const DescribeCommand &c) {
  check_distinct({c.file, c.output.path()});
  const DescribeOptions o = options(c);
  const SoilDescription d = describe(gradation(c), o);
  Output out(c.output.path());
  out.write(report(c, d));
  out.commit();
  c.output.tell_notes_beside_csv(d.notes);
  return d.limited() ? Exit::limited : Exit::done;
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
  command
      .add_option("--liquid-limit", c->liquid_limit,
                  "of the fines, in percent; without limits they are low-plasticity silt")
      ->type_name("LL");
  command.add_option("--plastic-limit", c->plastic_limit, "of the fines, in percent")->type_name("PL");
  command.add_flag("--extrapolate", c->extrapolate,
                   "continue the line through the two finest sieves into a pan at size 0");
  command.add_option("--pan-size", c->pan_size, "take the pan as a sieve of this size")->type_name("SIZE");
  command.add_option("--digits", c->digits, "significant digits (15; in the text form 4)")
      ->type_name("D")
      ->check(CLI::Range(1, 1000));
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no notes on standard error");
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
