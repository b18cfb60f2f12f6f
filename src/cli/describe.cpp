#include "commands.hpp"
#include "files.hpp"

#include <mdm/error.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/description.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct DescribeCommand {
  std::string file;
  std::optional<std::string> liquid_limit, plastic_limit, pan_size, specimen_id;
  std::optional<unsigned> digits;
  bool extrapolate = false;
  std::string format = "text";
  std::string out = "-";
  bool quiet = false;
};

Rational number(const char *option, const std::string &text) {
  try {
    return parse_decimal(text);
  } catch (const InputError &e) {
    throw InputError(std::string(option) + ": " + e.what());
  }
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
  const std::string name = shown_name(c.file);
  Gradation g = read_gradation(read_file(c.file, max_gradation_bytes), name, c.specimen_id);
  if (!c.pan_size)
    return g;
  const Rational size = number("--pan-size", *c.pan_size);
  try {
    return g.with_pan_size(size);
  } catch (const InputError &e) {
    throw InputError(printable(name) + ": " + e.what());
  }
}

std::string report(const DescribeCommand &c, const SoilDescription &d) {
  constexpr unsigned exchanged = 15, read = 4;
  if (c.format == "json")
    return description_json(d, c.digits.value_or(exchanged)) + "\n";
  if (c.format == "csv")
    return description_csv(d, c.digits.value_or(exchanged));
  return description_text(d, c.digits.value_or(read));
}

int run(const DescribeCommand &c) {
  check_distinct({c.file, c.out});
  const DescribeOptions o = options(c);
  const SoilDescription d = describe(gradation(c), o);
  Output out(c.out);
  out.write(report(c, d));
  out.commit();
  // CSV has no place for them.
  if (c.format == "csv" && !c.quiet)
    for (const std::string &note : d.notes)
      tell("note: " + note + "\n");
  return d.limited() ? Exit::limited : Exit::done;
}

} // namespace

Run add_describe(CLI::App &app) {
  const auto c = std::make_shared<DescribeCommand>();
  CLI::App &command =
      *app.add_subcommand("describe", "Index numbers, fractions and the soil group of a gradation");
  command.add_option("FILE", c->file, "gradation: CSV, JSON or AGS4; - for standard input")->required();
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
  command.add_option("--specimen-id", c->specimen_id, "the specimen of an AGS4 file with several")
      ->type_name("ID");
  command.add_option("--format", c->format, "text, json or csv")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command.add_option("-o", c->out, "write to OUT instead of standard output")->type_name("OUT");
  command.add_flag("--quiet", c->quiet, "no notes on standard error");
  command.footer(
      "Exit code 3: the group hangs on an interpolated share or an index that 1,200 digits do not tell\n"
      "from its limit; the report says which.\n\n"
      "Example: mdm describe sand.csv --liquid-limit 30 --plastic-limit 22");
  return [c] { return run(*c); };
}

} // namespace mdm::cli
