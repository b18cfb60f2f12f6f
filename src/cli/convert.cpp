#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/problem_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/regrading_flags.hpp"
#include "crosscheck/program_text.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/sample_file.hpp"
#include "report/reading_report.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <memory>

namespace mdm::cli {
namespace {

struct ConvertCommand {
  std::optional<std::string> file;
  RegradingFlags regrading;
  ReadingFlags reading;
  OutputFlags output;
  ProblemFlags problem;
  bool dry_run = false;
};

std::string understood(const ConvertCommand &c, const UnderstoodGradation &u) {
  if (c.output.is_json())
    return reading_json(u) + "\n";
  return reading_text(u, printable(shown_name(*c.file))) + "\n" + gradation_csv(u.gradation);
}

std::string converted(const ConvertCommand &c, const Regraded &r) {
  if (c.problem.is_given())
    return c.problem.text(r.gradation);
  return c.output.is_json() ? gradation_json(r.gradation)
                            : history_comments(r.history) + gradation_csv(r.gradation);
}

void check(const ConvertCommand &c) {
  c.problem.check(c.output);
  c.regrading.check(c.file);
  if (c.dry_run && !c.output.is_json() && (c.output.out || c.output.asked_format))
    throw InputError(option("dry-run") + ": nothing is converted: leave out -o and " + option("format") +
                     ", or ask for what was "
                     "understood with " +
                     option("format") + " json");
  if (c.dry_run && c.problem.is_given())
    throw InputError(option("problem") + ": " + option("dry-run") +
                     " shows how a file was read: leave out one");
  if (c.dry_run && c.regrading.is_given())
    throw InputError(option("dry-run") + " shows how one file was read: give the file alone");
  std::vector<std::string> files = c.regrading.files();
  if (c.file)
    files.push_back(*c.file);
  for (const std::string &file : files)
    check_distinct({file, c.output.path()});
}

UnderstoodGradation read_one(const ConvertCommand &c, PhiReading phi) {
  return any_gradation(*c.file, c.reading, c.output.quiet, phi);
}

int show_understood(const ConvertCommand &c) {
  const UnderstoodGradation u = read_one(c, c.output.is_json() ? PhiReading::exact : PhiReading::rounded);
  Output out(c.output.path());
  out.write(in_file(*c.file, [&] { return understood(c, u); }));
  out.commit();
  return Exit::done;
}

/// Sizes that are written as numbers are; a problem has them as they are.
PhiReading phi_of(const ConvertCommand &c) {
  return c.problem.is_given() ? PhiReading::exact : PhiReading::rounded;
}

/// The gradation that is written, with its history where it was changed.
Regraded asked_gradation(const ConvertCommand &c, const std::string &name) {
  if (!c.regrading.is_given())
    return {read_one(c, phi_of(c)).gradation, {}};
  std::string made = "made by mdm convert of " + name;
  if (c.file)
    return c.regrading.changed({read_one(c, phi_of(c)).gradation, {std::move(made)}}, name);
  Regraded g = c.regrading.joined_files(c.reading, c.output.quiet);
  g.history.insert(g.history.begin(), made + " and " + shown_name(c.regrading.files().back()));
  return c.regrading.changed(std::move(g), name);
}

int run(const ConvertCommand &c) {
  check(c);
  if (c.dry_run)
    return show_understood(c);
  const std::string name = shown_name(c.file ? *c.file : c.regrading.files().front());
  const Regraded g = asked_gradation(c, name);
  Output out(c.output.path());
  out.write(in_file(name, [&] { return converted(c, g); }));
  out.commit();
  c.output.tell_notes(g.gradation.notes());
  c.output.tell_notes(g.history);
  if (!g.gradation.roundings().empty() && !c.problem.is_given())
    c.output.tell_notes(
        {"The percents were rounded to their last digit; in what is written they are masses, which "
         "mdm judge takes as exact unless " +
         option("rounding", OptionSpelling::program) + " says otherwise."});
  return Exit::done;
}

} // namespace

Run add_convert(CLI::App &app) {
  const auto c = std::make_shared<ConvertCommand>();
  CLI::App &command = *app.add_subcommand("convert", "Any gradation file as canonical CSV or JSON");
  command.add_option(
      "FILE", c->file,
      "gradation: CSV, JSON, AGS4, DIGGS, a table or workbook of a laboratory, a file of an "
      "instrument; or a set of mdm generate or file of particles, whose gradation it is; - for "
      "standard input");
  std::vector<std::string> endings = {"csv", "txt", "json"};
  for (const std::string &language : program_language_names())
    if (language != "json")
      endings.push_back(language);
  c->output.add_out(command, "write", endings);
  command.add_option("--format", c->output.asked_format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command.add_flag("--dry-run", c->dry_run,
                   "show what was understood: the table, its unit and kind, pan and notes; also as JSON");
  c->output.add_quiet(command, "no notes on standard error");
  c->regrading.add_to(command);
  c->reading.add_to(command);
  c->problem.add_to(command);
  command.footer(footer(
      paragraph("A joint, and a sieve at which grains are left out or replaced, is a sieve of the file, or "
                "lies where there is no mass: nothing is interpolated. What was moved is in the comments of "
                "the CSV, which mdm-check passes over, and beside JSON on standard error. Options of reading "
                "are for both files; where they differ, convert each by itself first.") +
          "\n" +
          paragraph(
              "A problem minimises the sum of q1, q2 and so on, the particles of the classes from the finest "
              "on, in whole numbers as long as they are; comments say what its rows are. A solver that "
              "counts in floating point may miss what decides: mdm crosscheck judges its answer."),
      {"mdm convert report.ags --specimen-id BH1 -o sand.csv",
       "mdm convert sieving.xlsx --sheet Sand --dry-run",
       "mdm convert half-phi.csv --format csv | mdm solve - --tolerance retained:1%",
       "mdm convert --join sieves.csv hydrometer.csv --at 75um -o soil.csv",
       "mdm convert --split coarse.csv fine.csv --at 4.75mm --fine-mass 812.4",
       "mdm convert rockfill.csv --replace above:20mm into 5mm..20mm",
       "mdm convert rockfill.csv --scalp above:80mm --parallel 1/5",
       "mdm convert sand.csv --problem smt2 --tolerance retained:1% | z3 -in"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
