#include "ask/crosscheck_options.hpp"
#include "cli/commands.hpp"
#include "cli/help.hpp"
#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/sample_file.hpp"
#include "cli/solve_flags.hpp"
#include "crosscheck/program_text.hpp"
#include "files/file_ending.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "report/reading_report.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <memory>

namespace mdm::cli {
namespace {

struct ConvertCommand {
  std::string file;
  ReadingFlags reading;
  OutputFlags output;
  bool dry_run = false;
  std::optional<std::string> problem; ///< the language of a problem
  CrosscheckTexts asked;              ///< the question that it is of
};

/// The integer program of the question about a gradation, in the language that is asked for.
std::string problem_in(const ConvertCommand &c, const Gradation &g) {
  const ProgramLanguage language = program_language_named(*c.problem).value();
  const Question question = CrosscheckQuestion(c.asked, band_in_file).question(g.unit());
  return program_text(integer_program(g, question, form_of(language), *c.problem), language);
}

void check_problem(const ConvertCommand &c) {
  if (!c.problem && !c.asked.question_words().empty())
    throw InputError(c.asked.question_words() + ": it is of a question: give " + option("problem") + " too");
  if (c.problem && (c.dry_run || c.output.asked_format.value_or(*c.problem) != *c.problem))
    throw InputError(option("problem") + " names the form of what is written: leave out " +
                     option("dry-run") + " and " + option("format"));
  const std::string ending = c.output.out ? ending_of(*c.output.out) : "";
  const bool is_other = c.problem ? ending == "csv" || program_language_named(ending).value_or(
                                                           program_language_named(*c.problem).value()) !=
                                                           program_language_named(*c.problem)
                                  : ending != "json" && program_language_named(ending);
  if (is_other)
    throw InputError(shown_name(*c.output.out) + ": the ending ." + ending +
                     " is not that of what is written: " +
                     (c.problem ? "let it be ." + *c.problem : "give " + option("problem") + " " + ending));
}

std::string converted(const ConvertCommand &c, const UnderstoodGradation &u) {
  if (c.dry_run && c.output.is_json())
    return reading_json(u) + "\n";
  if (c.dry_run)
    return reading_text(u, printable(shown_name(c.file))) + "\n" + gradation_csv(u.gradation);
  return c.output.is_json() ? gradation_json(u.gradation) : gradation_csv(u.gradation);
}

int run(const ConvertCommand &c) {
  check_problem(c);
  if (c.dry_run && !c.output.is_json() && (c.output.out || c.output.asked_format))
    throw InputError(option("dry-run") + ": nothing is converted: leave out -o and " + option("format") +
                     ", or ask for what was "
                     "understood with " +
                     option("format") + " json");
  check_distinct({c.file, c.output.path()});
  const bool writes_sizes = !c.problem && !(c.dry_run && c.output.is_json());
  const UnderstoodGradation u = any_gradation(c.file, c.reading, c.output.quiet,
                                              writes_sizes ? PhiReading::rounded : PhiReading::exact);
  Output out(c.output.path());
  out.write(in_file(c.file, [&] { return c.problem ? problem_in(c, u.gradation) : converted(c, u); }));
  out.commit();
  if (!c.dry_run)
    c.output.tell_notes(u.gradation.notes());
  return Exit::done;
}

} // namespace

Run add_convert(CLI::App &app) {
  const auto c = std::make_shared<ConvertCommand>();
  CLI::App &command = *app.add_subcommand("convert", "Any gradation file as canonical CSV or JSON");
  command
      .add_option("FILE", c->file,
                  "gradation: CSV, JSON, AGS4, DIGGS, a table or workbook of a laboratory, a file of an "
                  "instrument; or a set of mdm generate or file of particles, whose gradation it is; - for "
                  "standard input")
      ->required();
  c->output.add_out(command, "write", {"csv", "txt", "json", "lp", "mps", "smt2", "mzn", "opb"});
  command.add_option("--format", c->output.asked_format, "csv or json; json if OUT ends so, else csv")
      ->check(CLI::IsMember({"csv", "json"}));
  command.add_flag("--dry-run", c->dry_run,
                   "show what was understood: the table, its unit and kind, pan and notes; also as JSON");
  command
      .add_option("--problem", c->problem,
                  "write the integer program of the question, for other solvers: lp, mps, smt2 (z3), mzn "
                  "(MiniZinc), opb (pseudo-Boolean) or json; its optimum is a smallest match")
      ->type_name("LANGUAGE")
      ->check(CLI::IsMember({"lp", "mps", "smt2", "mzn", "opb", "json"}));
  c->output.add_quiet(command, "no notes on standard error");
  c->reading.add_to(command);
  add_asked_options(command, c->asked);
  command.footer(footer(
      paragraph(
          "A problem minimises the sum of q1, q2 and so on, the particles of the classes from the finest on, "
          "in whole numbers as long as they are; comments say what its rows are. A solver that counts in "
          "floating point may miss what decides: mdm crosscheck judges its answer."),
      {"mdm convert report.ags --specimen-id BH1 -o sand.csv",
       "mdm convert sieving.xlsx --sheet Sand --dry-run",
       "mdm convert half-phi.csv --format csv | mdm solve - --tolerance retained:1%",
       "mdm convert sand.csv --problem smt2 --tolerance retained:1% | z3 -in"}));
  return [c] { return run(*c); };
}

} // namespace mdm::cli
