#include "ask/option_values.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/whole_number.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "report/conformity_report.hpp"

#include <mdm/gradation/read_gradation.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace mdm::cli {
namespace {

struct JudgeCommand {
  std::vector<std::string> files;
  std::optional<std::string> spec, rounding;
  ReadingFlags reading;
  std::optional<unsigned> digits;
  OutputFlags output;
};

/// The one of that name, or that in the file.
Specification specification(const std::string &name) {
  if (std::optional<Specification> s = shipped_specification(name))
    return *std::move(s);
  try {
    return read_specification(read_file(name, max_gradation_bytes), shown_name(name));
  } catch (const InputError &e) {
    if (file_bytes(name) || name == "-")
      throw;
    throw InputError(fmt::format("--spec: {}; specifications that come with mdm: {}", e.what(),
                                 fmt::join(shipped_specifications(), ", ")));
  }
}

/// One unit of the last digit; 0 for none.
std::optional<Rational> rounding(const JudgeCommand &c) {
  if (!c.rounding)
    return std::nullopt;
  return *c.rounding == "none" ? Rational(0) : percent_of("rounding", *c.rounding);
}

void check(const JudgeCommand &c) {
  if (!c.spec)
    throw InputError(fmt::format("--spec is missing: give a file of limits, or one of {}",
                                 fmt::join(shipped_specifications(), ", ")));
  std::vector<std::string> inputs = c.files;
  inputs.push_back(*c.spec);
  if (std::count(inputs.begin(), inputs.end(), "-") > 1)
    throw InputError("-: standard input is one file: give the others by name");
  for (const std::string &input : inputs)
    check_distinct({input, c.output.path()});
}

std::string report(const JudgeCommand &c, const ConformityReport &r) {
  constexpr unsigned exchanged = 15, read = 6;
  return c.output.report([&] { return conformity_text(r, c.digits.value_or(read)); },
                         [&] { return conformity_json(r, c.digits.value_or(exchanged)); },
                         [&] { return conformity_csv(r, c.digits.value_or(exchanged)); });
}

std::vector<std::string> all_notes(const ConformityReport &r) {
  std::vector<std::string> notes = r.specification.notes;
  for (const Conformity &c : r.samples)
    for (const std::string &note : c.notes)
      notes.push_back(c.id + ": " + note);
  return notes;
}

int run(const JudgeCommand &c) {
  check(c);
  const std::optional<Rational> unit = rounding(c);
  ConformityReport r{specification(*c.spec), {}};
  for (const std::string &file : c.files) {
    const UnderstoodGradation g = any_gradation(file, c.reading, c.output.quiet);
    r.samples.push_back(in_file(file, [&] { return judge(g, r.specification, unit); }));
  }
  Output out(c.output.path());
  out.write(report(c, r));
  out.commit();
  c.output.tell_notes_beside_csv(all_notes(r));
  switch (r.verdict()) {
  case Compliance::holds:
    return Exit::done;
  case Compliance::undecided:
    return Exit::limited;
  default:
    return Exit::negative;
  }
}

} // namespace

Run add_judge(CLI::App &app) {
  const auto c = std::make_shared<JudgeCommand>();
  CLI::App &command = *app.add_subcommand(
      "judge", "Whether samples keep a specification, whatever was rounded in their reports");
  command
      .add_option(
          "SAMPLE", c->files,
          "gradations (any that mdm convert reads), sets of mdm generate, or files of particles as mdm "
          "verify reads; - for standard input")
      ->required();
  command
      .add_option(
          "--spec", c->spec,
          fmt::format("limits of the percent that passes: a table with "
                      "passing_min_percent,passing_max_percent or columns such as Lower and Upper, or one "
                      "of {}",
                      fmt::join(shipped_specifications(), ", ")))
      ->type_name("FILE|NAME");
  command
      .add_option(
          "--rounding", c->rounding,
          "one unit of the last digit of all percents, as 0.1, or none (as the report prints its percents; "
          "masses are exact)")
      ->type_name("UNIT");
  command.add_option("--digits", c->digits, "significant digits (15; in the text form 6)")
      ->type_name("D")
      ->transform(whole_number(1, 1000));
  c->output.add_format(command);
  c->output.add_out(command);
  c->output.add_quiet(command, "no progress, and no notes beside CSV, on standard error");
  c->reading.add_to(command);
  command.footer(footer(
      paragraph(
          "A percent in a report stands for all numbers that round to it. The verdict is pass where every "
          "curve that rounds to the report keeps the limits, fail where none does, and else hangs: then a "
          "curve on either side is shown. At a size where a sample has no sieve, what passes is "
          "interpolated, linear in log size, and decided exactly. Of several samples there is a table with a "
          "column each.") +
          "\n" +
          paragraph(
              "Exit code 0: all samples pass. 1: one fails, or hangs, which is no pass. 3: 1,200 digits do "
              "not tell a percent from its limit. --spec NAME has grading limits alone: what else the "
              "standard asks is not judged."),
      {"mdm judge sand.csv --spec astm-c33-fine", "mdm judge a.csv b.csv --spec limits.csv --format csv",
       "mdm judge base.csv --spec superpave-19 --rounding 0.1"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
