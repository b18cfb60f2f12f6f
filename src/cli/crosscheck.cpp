#include "ask/crosscheck_options.hpp"
#include "ask/option_values.hpp"
#include "ask/outcome.hpp"
#include "cli/commands.hpp"
#include "cli/crosscheck_blends.hpp"
#include "cli/help.hpp"
#include "cli/interrupted.hpp"
#include "cli/known_minima.hpp"
#include "cli/option_tables.hpp"
#include "cli/output_flags.hpp"
#include "cli/solve_flags.hpp"
#include "cli/whole_number.hpp"
#include "crosscheck/answer_index.hpp"
#include "crosscheck/crosscheck_report.hpp"
#include "crosscheck/solution_reader.hpp"
#include "files/answer_proofs.hpp"
#include "files/blend_lines.hpp"
#include "files/byte_source.hpp"
#include "files/file_ending.hpp"
#include "files/in_parallel.hpp"
#include "files/interrupt.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "files/progress_line.hpp"
#include "files/proof_stream.hpp"
#include "files/solver.hpp"
#include "files/suite_lines.hpp"
#include "text/json_writer.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <functional>
#include <memory>

namespace mdm::cli {
namespace {

struct CrosscheckCommand {
  std::string suite;
  std::optional<std::string> answers, solver, solution, by, journal, proofs, minimum;
  std::optional<std::string> time_limit; ///< of a solver
  CrosscheckTexts asked;
  OutputFlags output;
  unsigned threads = 1;
  bool reasons = false;
  bool require_minimal = false;

  bool has_proof_stream() const { return proofs && names_proof_stream(*proofs); }
};

using Rows = std::vector<CrosscheckRow>;

/// What is found of a gradation of the suite.
struct JudgedLine {
  Rows rows;
  AnswerProofs::OfGradation proofs;
};
using Judge = std::function<JudgedLine(const Crosscheck &, const SuiteLine &)>;

std::chrono::milliseconds read_time_limit(const std::string &text) {
  const Integer a_year = 366LL * 24 * 3600 * 1000;
  const Integer limit = ceil(Rational(positive("time-limit", text) * 1000));
  return std::chrono::milliseconds(static_cast<std::int64_t>(std::min(limit, a_year)));
}

void check_options(const CrosscheckCommand &c) {
  if (int{c.answers.has_value()} + int{c.solver.has_value()} + int{c.solution.has_value()} != 1)
    throw InputError("crosscheck: give a file of ANSWERS, a program with " + option("solver") +
                     ", or the file of one solution with " + option("solution"));
  if (c.solution && (c.journal || c.time_limit || c.by))
    throw InputError(option("journal") + ", " + option("time-limit") + " and " + option("by") +
                     ": a file of one solution is read: leave them out");
  if (c.answers && (c.journal || c.time_limit))
    throw InputError(option("journal") + " and " + option("time-limit") + " are for " + option("solver") +
                     ": a file is judged in one go");
  if (c.solver && c.by)
    throw InputError(option("by") + " is for a file of ANSWERS: a solver answers once");
  if (c.suite == "-" && (c.answers == "-" || c.solution == "-"))
    throw InputError("standard input cannot be both SUITE and the answers: name a file for one of them");
  if (c.output.is_text() && c.output.out)
    check_ending(*c.output.out, {"csv", "txt"}, "crosscheck",
                 ", or say with " + option("format") + " json what it holds");
  if (c.output.is_text() && c.output.out == "-")
    throw InputError("-o -: standard output has the summary: use " + option("format") + " csv");
  if (c.minimum && c.solution)
    throw InputError(option("minimum") + " is of the lines of a suite, and " + option("solution") +
                     " of one gradation: leave it out");
  if (c.minimum && c.asked.question_words().empty())
    throw InputError(option("minimum") + ": the least match of this question is found at once: leave it out");
  if (c.journal == "-")
    throw InputError(option("journal") + " needs a file: name one");
  if (c.solution && c.has_proof_stream())
    throw InputError(option("proofs") + ": a stream of proofs is that of a suite, and " + option("solution") +
                     " is of one gradation: name a folder");
  const std::string stream = c.has_proof_stream() ? *c.proofs : "-",
                    index = c.has_proof_stream() ? proof_index_path(*c.proofs) : "-";
  for (const std::string &input : {c.suite, c.answers.value_or("-"), c.solution.value_or("-"),
                                   c.minimum.value_or("-"), c.minimum ? proof_index_path(*c.minimum) : "-"})
    check_distinct({input, c.journal.value_or("-"), c.output.path(), stream, index});
}

/// Rows as they come, and what stands around them.
class Report {
public:
  Report(const CrosscheckCommand &command, const Rational &size_tolerance)
      : command_(command), columns_{command.by.value_or(""), command.reasons} {
    const std::string question = command.asked.question_words();
    if (!question.empty())
      question_ = question;
    if (!command.output.is_text() || command.output.out)
      rows_to_.emplace(command.output.path());
    if (json())
      begin_crosscheck(
          json_, {command.suite, command.answers, command.solver, command.by, question_, size_tolerance});
  }

  void add(const Rows &rows) {
    for (const CrosscheckRow &row : rows) {
      if (json())
        write_row(json_.new_line(), row, command_.by.has_value());
      else if (rows_to_)
        rows_to_->write(csv_header() + crosscheck_csv(row, columns_));
      summary_.add(row);
    }
    if (json() && !rows.empty())
      json_.hand_on();
  }

  void end(std::uint64_t gradations, const std::vector<std::string> &notes) {
    if (json()) {
      end_crosscheck(json_, summary_, command_.by.has_value(), notes);
      json_.hand_on();
      rows_to_->write("\n");
    } else if (rows_to_) {
      rows_to_->write(csv_header());
    }
    if (command_.output.is_text())
      write_output("-", crosscheck_text(printable(shown_name(command_.suite)), question_, gradations,
                                        summary_, columns_, notes));
    command_.output.tell_notes_beside_csv(notes);
    if (rows_to_)
      rows_to_->commit();
  }

  Outcome outcome() const { return outcome_of(summary_, command_.require_minimal); }

private:
  bool json() const { return command_.output.is_json(); }

  /// Before the first row; nothing is written before it, as it may fail.
  std::string csv_header() const {
    return summary_.settings().empty() ? crosscheck_csv_header(columns_) : "";
  }

  const CrosscheckCommand &command_;
  CrosscheckColumns columns_;
  std::optional<std::string> question_;
  std::optional<Output> rows_to_;
  const Sink sink_ = [this](std::string_view text) { rows_to_->write(text); };
  JsonWriter json_{sink_};
  CrosscheckSummary summary_;
};

/// Judges the gradations of the suite up to the first that was not begun when Ctrl-C was pressed.
/// \param proofs null for none \return how many were judged
std::size_t report_suite(const CrosscheckCommand &c, const CrosscheckQuestion &question,
                         const std::vector<SuiteLine> &suite, const Judge &judge, AnswerProofs *proofs,
                         Report &report) {
  const std::optional<KnownMinima> minima = c.minimum ? std::optional<KnownMinima>(*c.minimum) : std::nullopt;
  std::atomic<std::size_t> done = 0;
  ProgressLine progress([&] { return fmt::format("{} of {} gradations", done.load(), suite.size()); },
                        c.output.quiet);
  const ProgressCall go_on = [](const Progress &) { return !Interrupt::was_pressed(); };
  const auto judged = [&](std::size_t i) {
    const SuiteLine &of = suite[i];
    const auto problem = [&] {
      const Question asked = question.question(of.gradation);
      const std::optional<KnownMinimum> known = minima ? minima->of(of, asked) : std::nullopt;
      return known ? Crosscheck::with_minimum(of.gradation, asked, *known)
                   : question.problem(of.gradation, go_on);
    };
    return judge(question.is_plain() ? problem() : in_file(line_name(c.suite, of.line), problem), of);
  };
  std::optional<Interrupt> interrupt;
  if (!c.solver) // which Ctrl-C ends on the spot: its journal has the answers
    interrupt.emplace();
  const auto give = [&](const JudgedLine &of) {
    report.add(of.rows);
    if (proofs)
      proofs->write(suite[done], of.proofs);
    ++done;
  };
  return in_order<JudgedLine>(suite.size(), c.threads, judged, give, Interrupt::was_pressed);
}

AnswerIndex read_index(const CrosscheckCommand &c) {
  constexpr std::size_t most = std::size_t{1} << 30;
  std::vector<OtherAnswer> answers = read_answers(read_file(*c.answers, most), shown_name(*c.answers));
  return in_file(*c.answers, [&] {
    return named("by", "", [&](const std::string &) { return AnswerIndex(std::move(answers), c.by); });
  });
}

/// The solution of the program of one gradation.
Solution solution_in(const std::string &path, const Gradation &g, const Question &question) {
  constexpr std::size_t most = std::size_t{1} << 26;
  const std::string text = read_file(path, most);
  const ProgramForm form = has_binary_values(text) ? ProgramForm::integers : ProgramForm::strict;
  return read_solution(text, integer_program(g, question, form, "the solution"));
}

/// Judges blends. \throws InputError where an option is given that is of gradations
int run_blends(const CrosscheckCommand &c, FileLines &lines) {
  if (c.solution || c.by || c.journal || c.proofs || c.minimum || c.asked.size_tolerance ||
      c.asked.max_steps || c.asked.node_limit || !c.asked.question_words().empty())
    throw file_error(c.suite,
                     "it has problems of blends, whose lines say all that is asked: leave out the options of "
                     "gradations");
  return crosscheck_blends(lines, {c.suite, c.answers, c.solver, read_time_limit(c.time_limit.value_or("60")),
                                   c.threads, c.require_minimal, c.output});
}

std::vector<SuiteLine> suite_of(const CrosscheckCommand &c, FileLines &lines) {
  if (!c.solution)
    return read_suite(lines, c.suite);
  return {{1, read_gradation(lines.rest(max_gradation_bytes), shown_name(c.suite))}};
}

int run(const CrosscheckCommand &c) {
  check_options(c);
  const Rational size_tolerance = c.asked.most_size_error();
  FileLines lines(c.suite);
  if (begin_blends(lines))
    return run_blends(c, lines);
  const std::vector<SuiteLine> suite = suite_of(c, lines);
  const CrosscheckQuestion question(c.asked, band_in_file);
  std::optional<AnswerProofs> proofs;
  if (c.proofs)
    proofs.emplace(*c.proofs, question, size_tolerance);
  const auto certify = [&](const Crosscheck &problem, const OtherAnswer &answer, JudgedLine &judged) {
    if (proofs)
      judged.proofs.push_back(proofs->made(problem.gradation(), answer));
  };
  const auto judged_one = [&](const Crosscheck &problem, const OtherAnswer &answer) {
    JudgedLine judged{{problem.judge(answer, size_tolerance)}, {}};
    certify(problem, answer, judged);
    return judged;
  };
  std::size_t done = 0;
  const auto report_all = [&](const Judge &judge, Report &report) {
    done = report_suite(c, question, suite, judge, proofs ? &*proofs : nullptr, report);
    return done == suite.size();
  };
  const auto end = [&](Report &report, std::vector<std::string> notes) {
    const bool is_whole = done == suite.size();
    if (!is_whole)
      notes.push_back(interrupted_after(done, "gradation"));
    if (proofs) {
      proofs->commit();
      notes.push_back(proofs->note(c.suite));
    }
    report.end(done, notes);
    const int exit = exit_code(report.outcome());
    return is_whole ? exit : worse_exit(exit, Exit::limited);
  };
  if (c.answers) {
    const AnswerIndex index = read_index(c);
    Report report(c, size_tolerance);
    const Judge judge = [&](const Crosscheck &problem, const SuiteLine &) {
      JudgedLine judged;
      judged.rows = index.judge(problem, size_tolerance,
                                [&](const OtherAnswer &answer) { certify(problem, answer, judged); });
      return judged;
    };
    if (!report_all(judge, report)) // which answers have no gradation is not known
      return end(report, {});
    report.add(index.rows_without_id());
    return end(report, index.notes());
  }
  if (c.solution) {
    const Gradation &g = suite.front().gradation;
    const Solution solution =
        in_file(*c.solution, [&] { return solution_in(*c.solution, g, question.question(g)); });
    Report report(c, size_tolerance);
    const Judge judge = [&](const Crosscheck &problem, const SuiteLine &) {
      return judged_one(problem, solution.answer);
    };
    report_all(judge, report);
    std::vector<std::string> notes = g.notes();
    notes.insert(notes.end(), solution.notes.begin(), solution.notes.end());
    return end(report, std::move(notes));
  }
  const std::string limit = c.time_limit.value_or("60");
  Solver solver(*c.solver, read_time_limit(limit), c.journal);
  Report report(c, size_tolerance);
  const Judge judge = [&](const Crosscheck &problem, const SuiteLine &entry) {
    return judged_one(problem, solver.answer(problem.gradation(), entry.line));
  };
  report_all(judge, report);
  return end(report, {});
}

/// The end of the help.
std::string about() {
  return paragraph(
             "A match is a vector of quantities that some sizes make an exact match, and whose sizes, "
             "where the answer has them, are right for one such match within --size-tolerance. Its "
             "ratio is N over the smallest N; quartiles are the ratios at the places n/4, n/2, 3n/4 "
             "(rounded down, counted from 0) of n in ascending order. max_error: the largest error of "
             "a class's share in percent, of the sizes as they stand in the answer. Verdicts: minimal, "
             "larger; not-a-match (--reasons says why); undecided (stopped at --max-steps); "
             "no-answer, garbage, crashed (a signal or an exit code other than 0), timeout, gave-up (the "
             "answer's status), infeasible (a status that is wrong: there is a match).") +
         "\n" +
         paragraph("With --tolerance, --band, --min-per-class and the like, the quantities are a match if "
                   "there are sizes in their classes (within --size-tolerance of those that are stated) with "
                   "which all of the question holds, by an exact linear program; the classes are those of "
                   "the gradation after --pan-size, --cut-below and --size-factor. That these were asked is "
                   "yours to tell the solver.") +
         "\n" +
         paragraph(
             "ANSWERS is CSV with a header: id, quantities (separated by spaces; one a class with mass, "
             "or one a class), optionally sizes_mm, sizes_um, sizes_m or sizes_in (- where there are no "
             "particles), and any other columns, for --by; or JSON Lines: answers of mdm batch, or "
             "{\"id\": \"a\", \"quantities\": [\"15\", \"2\"], \"sizes\": [\"0.07\", \"0.14\"], \"unit\": "
             "\"mm\"}, sizes and unit (mm) optional. Ids need not be unique: each gradation of an id is "
             "held against each answer of that id.") +
         "\n" +
         paragraph("The solver gets one gradation as JSON on its standard input, writes one such object (the "
                   "id may be left out) to its standard output and exits with 0. A journal keeps failures "
                   "too, also a timeout: to ask again, name a new one. It knows what was asked: an answer to "
                   "a gradation that was corrected since is not used.") +
         "\n" +
         paragraph(
             "SUITE may also have problems of blends, as mdm blend --problems takes them: then an answer is "
             "{\"id\": \"a\", \"shares\": [\"0.61\", \"0.39\"]}, or \"percents\", or a status of infeasible "
             "or "
             "gave-up. Verdicts are best, worse, not-a-blend (--format csv says why) and those above.") +
         "\n" +
         paragraph(
             "Exit code: 0 if every answer is a match (with --require-minimal: minimal), 1 if not, 2 if "
             "a line of SUITE is bad (before anything is run), 3 if something is undecided. Ctrl-C ends the "
             "judgement of answers with the rows so far (exit 3), and a run of a solver on the spot.");
}

} // namespace

Run add_crosscheck(CLI::App &app) {
  const auto c = std::make_shared<CrosscheckCommand>();
  CLI::App &command =
      *app.add_subcommand("crosscheck", "Judges another solver's answers to a suite of gradations");
  command
      .add_option("SUITE", c->suite, "gradations, or problems of blends, JSON Lines; - for standard input")
      ->required();
  command.add_option("ANSWERS", c->answers, "the answers: CSV or JSON Lines; - for standard input");
  command.add_option("--solver", c->solver, "run CMD with /bin/sh for each gradation in place of ANSWERS")
      ->type_name("CMD");
  command
      .add_option(
          "--solution", c->solution,
          "SUITE is one gradation in any format, and FILE what a solver wrote for the problem of mdm convert "
          "--problem: its counts q1, q2 and so on")
      ->type_name("FILE");
  command
      .add_option("--time-limit", c->time_limit,
                  "seconds after which a solver and its children are killed (60)")
      ->type_name("S");
  command.add_option("-j", c->threads, "threads, and solvers at once")
      ->type_name("THREADS")
      ->transform(whole_number(1, 1024));
  command
      .add_option("--journal", c->journal,
                  "append the solver's answers to FILE as they come (JSON Lines, good as ANSWERS too); a run "
                  "that was interrupted goes on from there when it is started again with the same command")
      ->type_name("FILE");
  add_options(command, CrosscheckTexts::options, c->asked);
  command.add_option("--by", c->by, "summary and missing answers by each value of a column of ANSWERS")
      ->type_name("COLUMN");
  command.add_flag("--reasons", c->reasons, "a last column `reason` in CSV rows");
  command.add_flag("--require-minimal", c->require_minimal, "exit 1 also if a match is larger than needed");
  command
      .add_option(
          "--minimum", c->minimum,
          "least matches that are known: the proofs that mdm batch SUITE --proofs STREAM wrote with the same "
          "question; they are checked, and only lines without one are solved")
      ->type_name("STREAM");
  command
      .add_option(
          "--proofs", c->proofs,
          "write a certificate of each answer, that it matches or does not, with its sample in canonical "
          "CSV, for mdm-check --suite: into the folder NAME, with its gradation; or, where NAME ends in "
          ".proofs or .proofs.zst, as one stream with the index NAME.index")
      ->type_name("NAME");
  add_options(command, CrosscheckTexts::limit_options, c->asked);
  add_asked_options(command, c->asked);
  c->output.add_format(command, "text (the summary), csv (the rows) or json (both); json if OUT ends so");
  c->output.out_has_report = false; // with text, it has the rows
  c->output.add_out(command, "write csv or json")
      ->description("write csv or json to OUT instead of standard output; with text, the rows as CSV");
  c->output.add_quiet(command, "no progress and no notes on standard error");
  command.footer(footer(
      about(), {"mdm crosscheck suite.jsonl answers.csv --by x_n_factor",
                "mdm crosscheck suite.jsonl answers.csv --tolerance passing:1% --min-per-class 5",
                "mdm crosscheck suite.jsonl answers.csv --tolerance retained:1% --minimum suite.proofs",
                "mdm crosscheck suite.jsonl --solver ./my-solver -j 2 -o rows.csv",
                "mdm crosscheck suite.jsonl answers.csv --proofs answers.proofs",
                "mdm crosscheck sand.csv --solution glpk.sol --tolerance retained:1%",
                "mdm crosscheck suite.jsonl --solver './my-solver --json' --journal run.jsonl"}));
  return [c] {
    if (!c->output.asked_format && ending_of(c->output.path()) == "json")
      c->output.asked_format = "json";
    return run(*c);
  };
}

} // namespace mdm::cli
