#include "child_process.hpp"
#include "commands.hpp"
#include "files.hpp"
#include "journal.hpp"
#include "progress.hpp"

#include <mdm/error.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/gradation/write_gradation.hpp>
#include <mdm/json_text.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/report/versions.hpp>
#include <mdm/study/crosscheck_report.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <memory>
#include <mutex>
#include <set>
#include <thread>
#include <unordered_map>

namespace mdm::cli {
namespace {

struct CrosscheckCommand {
  std::string suite;
  std::optional<std::string> answers, solver, by, journal, out;
  std::string size_tolerance = "1e-9";
  std::optional<std::string> time_limit;
  std::optional<std::uint64_t> max_steps;
  std::string format = "text";
  unsigned threads = 1;
  bool reasons = false;
  bool require_minimal = false;
  bool quiet = false;
};

std::string shown_name(const std::string &path) {
  return path == "-" ? "stdin" : path;
}

using Rows = std::vector<CrosscheckRow>;

/// Where answers come from: a file, or a solver.
class AnswerSource {
public:
  virtual ~AnswerSource() = default;
  /// Judges all answers to the gradation in that line of the suite. Several threads may call it.
  virtual Rows rows(const Crosscheck &problem, std::uint64_t line) = 0;
  /// What is to be said after the last line.
  virtual std::vector<std::string> notes() const { return {}; }
};

class AnswersInFile : public AnswerSource {
public:
  AnswersInFile(const std::string &path, std::optional<std::string> by, Rational size_tolerance)
      : by_(std::move(by)), size_tolerance_(std::move(size_tolerance)) {
    constexpr std::size_t most = std::size_t{1} << 30;
    answers_ = read_answers(read_file(path, most), shown_name(path));
    if (by_)
      check_column(path);
    for (std::size_t i = 0; i < answers_.size(); ++i) {
      by_id_[answers_[i].id].answers.push_back(i);
      const std::string setting = setting_of(answers_[i]);
      const bool counts = answers_[i].failure != Verdict::garbage &&
                          std::find(settings_.begin(), settings_.end(), setting) == settings_.end();
      if (counts)
        settings_.push_back(setting);
    }
    if (settings_.empty())
      settings_.emplace_back();
    unreadable_ids_ = by_id_.extract("");
  }

  Rows rows(const Crosscheck &problem, std::uint64_t) override {
    const auto found = by_id_.find(problem.gradation().id());
    Rows rows;
    std::set<std::string> answered;
    if (found != by_id_.end()) {
      found->second.found = true;
      for (const std::size_t i : found->second.answers) {
        rows.push_back(problem.judge(answers_[i], size_tolerance_));
        rows.back().setting = setting_of(answers_[i]);
        answered.insert(rows.back().setting);
      }
    }
    for (const std::string &setting : settings_) {
      if (answered.count(setting) > 0)
        continue;
      rows.push_back(
          problem.judge(failed_answer("", Verdict::no_answer, "the file has none"), size_tolerance_));
      rows.back().setting = setting;
    }
    std::stable_sort(rows.begin(), rows.end(), [this](const CrosscheckRow &a, const CrosscheckRow &b) {
      return place(a.setting) < place(b.setting);
    });
    return rows;
  }

  /// Answers that cannot be read so much as to tell what they answer.
  Rows rows_without_id() const {
    Rows rows;
    if (!unreadable_ids_.empty())
      for (const std::size_t i : unreadable_ids_.mapped().answers) {
        CrosscheckRow &row = rows.emplace_back();
        row.setting = setting_of(answers_[i]);
        row.verdict = Verdict::garbage;
        row.reason = answers_[i].failure == Verdict::garbage ? answers_[i].reason : "the answer has no id";
      }
    return rows;
  }

  std::vector<std::string> notes() const override {
    std::vector<std::string> strangers;
    std::size_t several = 0;
    for (const auto &[id, entry] : by_id_) {
      if (!entry.found)
        strangers.push_back(id);
      std::set<std::string> seen;
      const bool repeated = std::any_of(entry.answers.begin(), entry.answers.end(), [&](std::size_t i) {
        return !seen.insert(setting_of(answers_[i])).second;
      });
      several += repeated ? 1 : 0;
    }
    std::vector<std::string> notes;
    if (!strangers.empty())
      notes.push_back(
          fmt::format("the suite has no gradation for {} of the ids that have answers, such as {}",
                      strangers.size(), in_quotes(*std::min_element(strangers.begin(), strangers.end()))));
    if (several > 0)
      notes.push_back(fmt::format("{} ids have several answers{}; each is a row{}", several,
                                  by_ ? " of one setting" : "", by_ ? "" : hint()));
    return notes;
  }

private:
  struct Entry {
    std::vector<std::size_t> answers;
    std::atomic<bool> found = false; ///< the suite has the id
  };

  std::string setting_of(const OtherAnswer &answer) const {
    const auto label = by_ ? answer.labels.find(*by_) : answer.labels.end();
    return label == answer.labels.end() ? "" : label->second;
  }

  std::size_t place(const std::string &setting) const {
    return static_cast<std::size_t>(std::find(settings_.begin(), settings_.end(), setting) -
                                    settings_.begin());
  }

  std::set<std::string> columns() const {
    std::set<std::string> names;
    for (const OtherAnswer &answer : answers_)
      for (const auto &[name, value] : answer.labels)
        names.insert(name);
    return names;
  }

  std::string names() const {
    std::string text;
    for (const std::string &name : columns())
      text += (text.empty() ? "" : ", ") + in_quotes(name);
    return text;
  }

  /// How to tell several answers apart.
  std::string hint() const {
    const std::string all = names();
    return all.empty() ? "" : ": --by tells them apart by one of the columns " + all;
  }

  void check_column(const std::string &path) const {
    if (columns().count(*by_) == 0)
      throw InputError(fmt::format(
          "--by: {} has no column {}; {}", printable(shown_name(path)), in_quotes(*by_),
          names().empty() ? "there is none to group by: leave --by out" : "there are " + names()));
  }

  std::optional<std::string> by_;
  Rational size_tolerance_;
  std::vector<OtherAnswer> answers_;
  std::unordered_map<std::string, Entry> by_id_;
  std::unordered_map<std::string, Entry>::node_type unreadable_ids_;
  std::vector<std::string> settings_; ///< in the order of the file
};

class Solver : public AnswerSource {
public:
  Solver(std::string command, std::chrono::milliseconds time_limit, std::string limit_text,
         Rational size_tolerance, const std::optional<std::string> &journal)
      : command_(std::move(command)), time_limit_(time_limit), limit_text_(std::move(limit_text)),
        size_tolerance_(std::move(size_tolerance)) {
    if (journal)
      journal_ = std::make_unique<Journal>(*journal, command_);
    kill_children_on_signals();
  }

  Rows rows(const Crosscheck &problem, std::uint64_t line) override {
    const std::string &id = problem.gradation().id();
    if (const OtherAnswer *const kept = journal_ ? journal_->find(line, id) : nullptr)
      return {problem.judge(*kept, size_tolerance_)};
    OtherAnswer answer = ask(problem.gradation());
    answer.id = id;
    if (journal_)
      journal_->add(line, answer);
    return {problem.judge(answer, size_tolerance_)};
  }

private:
  OtherAnswer ask(const Gradation &g) const {
    constexpr std::size_t most_output = std::size_t{64} << 20;
    const ChildEnd end = run_child(command_, gradation_json(g), time_limit_, most_output);
    switch (end.how) {
    case ChildEnd::How::timed_out:
      return failed_answer("", Verdict::timeout, "no end within " + limit_text_ + " s");
    case ChildEnd::How::too_much_output:
      return failed_answer("", Verdict::garbage, "more than 64 MiB of output");
    case ChildEnd::How::signalled:
      return failed_answer("", Verdict::crashed, "signal " + std::to_string(end.code) + said(end));
    case ChildEnd::How::exited:
      break;
    }
    if (end.code != 0)
      return failed_answer("", Verdict::crashed, "exit code " + std::to_string(end.code) + said(end));
    if (end.output.find_first_not_of(" \t\r\n") == std::string::npos)
      return failed_answer("", Verdict::no_answer, "no output" + said(end));
    OtherAnswer answer = json_answer(end.output);
    if (!answer.id.empty() && answer.id != g.id())
      return failed_answer("", Verdict::garbage, "the answer is for " + in_quotes(answer.id));
    return answer;
  }

  static std::string said(const ChildEnd &end) {
    return end.last_error.empty() ? "" : ": " + in_quotes(end.last_error);
  }

  std::string command_;
  std::chrono::milliseconds time_limit_;
  std::string limit_text_;
  Rational size_tolerance_;
  std::unique_ptr<Journal> journal_;
};

/// The lines of a suite, worked on by several threads, their rows given out in order.
class Suite {
public:
  Suite(const CrosscheckCommand &command, AnswerSource &source)
      : command_(command), source_(source), lines_(command.suite) {
    limits_.max_steps = command.max_steps;
  }

  /// Calls give(rows) for each line that is not blank.
  template <class Give>
  void run(Give give) {
    const auto work = [this, &give] {
      try {
        while (const std::optional<Numbered> line = take())
          finish(line->number, rows(line->text, line->number), give);
      } catch (...) { // no bad line, but the end of the run
        const std::lock_guard lock(input_mutex_);
        failure_ = std::current_exception();
      }
    };
    std::vector<std::thread> helpers;
    for (unsigned t = 1; t < command_.threads; ++t)
      helpers.emplace_back(work);
    work();
    for (std::thread &helper : helpers)
      helper.join();
    if (failure_)
      std::rethrow_exception(failure_);
  }

  std::uint64_t done() const { return done_; }

private:
  struct Numbered {
    std::uint64_t number;
    Lines::Line text;
  };

  std::optional<Numbered> take() {
    const std::lock_guard lock(input_mutex_);
    if (failure_)
      return std::nullopt;
    std::vector<Lines::Line> next = lines_.next(1);
    if (next.empty())
      return std::nullopt;
    return Numbered{++taken_, std::move(next.front())};
  }

  Rows rows(const Lines::Line &line, std::uint64_t number) {
    const std::string fallback = std::to_string(number);
    const std::string where = shown_name(command_.suite) + ":" + fallback;
    if (!line)
      return {bad_problem(fallback, where + ": the line has more than 64 MiB")};
    if (line->find_first_not_of(" \t\r") == std::string::npos)
      return {};
    std::optional<Crosscheck> problem;
    try {
      problem.emplace(read_json_gradation(*line, where, fallback), limits_);
    } catch (const InputError &e) {
      return {bad_problem(json_gradation_id(*line).value_or(fallback), e.what())};
    }
    return source_.rows(*problem, number);
  }

  static CrosscheckRow bad_problem(std::string id, std::string reason) {
    CrosscheckRow row;
    row.id = std::move(id);
    row.verdict = Verdict::bad_problem;
    row.reason = std::move(reason);
    return row;
  }

  template <class Give>
  void finish(std::uint64_t number, Rows rows, Give &give) {
    const std::lock_guard lock(output_mutex_);
    waiting_.emplace(number, std::move(rows));
    for (auto next = waiting_.begin(); next != waiting_.end() && next->first == done_ + 1;
         next = waiting_.erase(next)) {
      give(next->second);
      ++done_;
    }
  }

  const CrosscheckCommand &command_;
  AnswerSource &source_;
  Limits limits_;
  std::mutex input_mutex_;
  Lines lines_;
  std::uint64_t taken_ = 0;
  std::exception_ptr failure_;
  std::mutex output_mutex_;
  std::map<std::uint64_t, Rows> waiting_; ///< for the rows of a line before them
  std::atomic<std::uint64_t> done_ = 0;
};

Rational read_tolerance(const std::string &text) {
  try {
    const Rational r = parse_decimal(text);
    if (r >= 0 && r < 1)
      return r;
  } catch (const InputError &e) {
    throw InputError(std::string("--size-tolerance: ") + e.what());
  }
  throw InputError("--size-tolerance: " + in_quotes(text) + " is not in [0, 1): it is relative to the size");
}

std::chrono::milliseconds read_time_limit(const std::string &text) {
  constexpr std::int64_t a_year = 366LL * 24 * 3600 * 1000;
  try {
    const Integer milliseconds = ceil(Rational(parse_decimal(text) * 1000));
    if (milliseconds > 0)
      return std::chrono::milliseconds(static_cast<std::int64_t>(std::min(milliseconds, Integer(a_year))));
  } catch (const InputError &e) {
    throw InputError(std::string("--time-limit: ") + e.what());
  }
  throw InputError("--time-limit: " + in_quotes(text) + " is not above 0 seconds");
}

void check_options(const CrosscheckCommand &c) {
  if (c.answers.has_value() == c.solver.has_value())
    throw InputError("crosscheck: give either a file of ANSWERS or a program with --solver");
  if (c.answers && (c.journal || c.time_limit))
    throw InputError("--journal and --time-limit are for --solver: a file is judged in one go");
  if (c.solver && c.by)
    throw InputError("--by is for a file of ANSWERS: a solver answers once");
  if (c.answers == "-" && c.suite == "-")
    throw InputError("standard input cannot be both SUITE and ANSWERS: name a file for one of them");
  if (c.format == "text" && c.out == "-")
    throw InputError("-o -: standard output has the summary: use --format csv");
  std::vector<std::string> paths = {c.suite};
  for (const std::optional<std::string> &path : {c.answers, c.journal, c.out})
    if (path)
      paths.push_back(*path);
  check_distinct(paths);
}

/// Rows as they come, and what stands around them.
class Report {
public:
  Report(const CrosscheckCommand &command, const Rational &size_tolerance) : command_(command) {
    columns_ = {command.by.value_or(""), command.reasons};
    if (command.format != "text" || command.out)
      rows_to_.emplace(command.out.value_or("-"));
    if (command.format == "json")
      rows_to_->write(fmt::format(
          R"({{"schema":"mdm-crosscheck-1","suite":{},"answers":{},"solver":{},"by":{},"size_tolerance":"{}","rows":[)",
          json_string(command.suite), json(command.answers), json(command.solver), json(command.by),
          to_string(size_tolerance)));
    else if (rows_to_)
      rows_to_->write(crosscheck_csv_header(columns_));
  }

  void add(const Rows &rows) {
    for (const CrosscheckRow &row : rows) {
      const bool first = summary_.settings().empty();
      summary_.add(row);
      if (command_.format == "json")
        rows_to_->write((first ? "\n" : ",\n") + crosscheck_json(row, command_.by.has_value()));
      else if (rows_to_)
        rows_to_->write(crosscheck_csv(row, columns_));
    }
  }

  void end(std::uint64_t problems, const std::vector<std::string> &notes) {
    if (command_.format == "json") {
      rows_to_->write(R"(],"summary":)" + summary_.json(command_.by.has_value()) + R"(,"notes":[)");
      for (std::size_t i = 0; i < notes.size(); ++i)
        rows_to_->write((i == 0 ? "" : ",") + json_string(notes[i]));
      rows_to_->write(R"(],"versions":{)");
      for (std::size_t i = 0; i < versions().size(); ++i)
        rows_to_->write((i == 0 ? "" : ",") + json_string(versions()[i].first) + ":" +
                        json_string(versions()[i].second));
      rows_to_->write("}}\n");
    }
    if (command_.format == "text") {
      Output out("-");
      std::string text = fmt::format("{}: {} {}\n\n", printable(shown_name(command_.suite)), problems,
                                     problems == 1 ? "gradation" : "gradations") +
                         summary_.text(columns_);
      for (const std::string &note : notes)
        text += "  note: " + note + "\n";
      out.write(text);
      out.commit();
    } else if (command_.format == "csv" && !command_.quiet) {
      for (const std::string &note : notes)
        tell("note: " + note + "\n");
    }
    if (rows_to_)
      rows_to_->commit();
  }

  int exit_code() const {
    if (summary_.count(Verdict::bad_problem) > 0)
      return Exit::bad_input;
    if (summary_.count(Verdict::undecided) > 0)
      return Exit::limited;
    for (const Verdict v : verdicts)
      if (v != Verdict::minimal && (v != Verdict::larger || command_.require_minimal) &&
          summary_.count(v) > 0)
        return Exit::negative;
    return Exit::done;
  }

private:
  static std::string json(const std::optional<std::string> &text) {
    return text ? json_string(*text) : "null";
  }

  const CrosscheckCommand &command_;
  CrosscheckColumns columns_;
  std::optional<Output> rows_to_;
  CrosscheckSummary summary_;
};

int run(const CrosscheckCommand &c) {
  check_options(c);
  const Rational size_tolerance = read_tolerance(c.size_tolerance);
  std::unique_ptr<AnswersInFile> file;
  std::unique_ptr<Solver> solver;
  if (c.answers) {
    file = std::make_unique<AnswersInFile>(*c.answers, c.by, size_tolerance);
  } else {
    const std::string limit = c.time_limit.value_or("60");
    solver = std::make_unique<Solver>(*c.solver, read_time_limit(limit), limit, size_tolerance, c.journal);
  }
  AnswerSource &source = file ? static_cast<AnswerSource &>(*file) : *solver;
  Suite suite(c, source);
  Report report(c, size_tolerance);
  std::uint64_t problems = 0;
  {
    Progress progress([&suite] { return fmt::format("{} gradations", suite.done()); }, c.quiet);
    suite.run([&](const Rows &rows) {
      if (!rows.empty())
        ++problems;
      report.add(rows);
    });
  }
  if (file)
    report.add(file->rows_without_id());
  report.end(problems, source.notes());
  return report.exit_code();
}

constexpr const char *footer =
    R"(A match is a vector of quantities that some sizes make an exact match, and whose sizes, where the
answer has them, are right for one such match within --size-tolerance. Its ratio is N over the least N.
max_error: the largest error of a class's share in percent, of the sizes as they stand in the answer.
Verdicts: minimal, larger; not-a-match (--reasons says why); undecided (stopped at --max-steps); no-answer,
garbage, crashed (a signal or an exit code other than 0), timeout; bad-problem (a bad line of SUITE).

ANSWERS is CSV with a header: id, quantities (separated by spaces; one a class with mass, or one a class),
optionally sizes_mm, sizes_um, sizes_m or sizes_in, and any other columns, for --by; or JSON Lines: answers
of mdm batch, or {"id": "a", "quantities": ["15", "2"], "sizes": ["0.07", "0.14"], "unit": "mm"}, sizes and
unit (mm) optional. The solver gets one gradation as JSON on its standard input, writes one such object (the
id may be left out) to its standard output and exits with 0. Ids need not be unique: each gradation of an id
is held against each answer of that id.

Exit code: 0 if every answer is a match (with --require-minimal: minimal), 1 if not, 2 if a line of SUITE is
bad, 3 if something is undecided.

Examples:
  mdm crosscheck tests/data/suite-2750.jsonl tests/data/suite-2750-float-answers.csv --by x_n_factor
  mdm crosscheck suite.jsonl --solver './solver --json' --time-limit 10 -j 2 --journal run.jsonl -o rows.csv)";

} // namespace

Run add_crosscheck(CLI::App &app) {
  const auto c = std::make_shared<CrosscheckCommand>();
  CLI::App &command =
      *app.add_subcommand("crosscheck", "Judges another solver's answers to a suite of gradations");
  command.add_option("SUITE", c->suite, "gradations, JSON Lines; - for standard input")->required();
  command.add_option("ANSWERS", c->answers, "the answers: CSV or JSON Lines; - for standard input");
  command.add_option("--solver", c->solver, "run CMD with /bin/sh for each gradation in place of ANSWERS")
      ->type_name("CMD");
  command
      .add_option("--time-limit", c->time_limit,
                  "seconds after which a solver and its children are killed (60)")
      ->type_name("S");
  command.add_option("-j", c->threads, "threads, and solvers at once")
      ->type_name("THREADS")
      ->check(CLI::Range(1, 1024));
  command
      .add_option("--journal", c->journal,
                  "append the solver's answers to FILE as they come (JSON Lines, good as ANSWERS too); a run "
                  "that was interrupted goes on from there when it is started again with the same command")
      ->type_name("FILE");
  command
      .add_option("--size-tolerance", c->size_tolerance,
                  "how far sizes may be off, as a part of the size as stated (1e-9)")
      ->type_name("EPS");
  command.add_option("--by", c->by, "summary and missing answers by each value of a column of ANSWERS")
      ->type_name("COLUMN");
  command.add_flag("--reasons", c->reasons, "a last column `reason` in CSV rows");
  command.add_flag("--require-minimal", c->require_minimal, "exit 1 also if a match is larger than needed");
  command
      .add_option("--max-steps", c->max_steps,
                  "stop the search for a least match after so many steps (undecided, exit 3)")
      ->type_name("N");
  command.add_option("--format", c->format, "text (the summary), csv (the rows) or json (both)")
      ->check(CLI::IsMember({"text", "json", "csv"}));
  command
      .add_option("-o", c->out,
                  "write csv or json to OUT instead of standard output; with text, the rows as CSV")
      ->type_name("OUT");
  command.add_flag("--quiet", c->quiet, "no progress and no notes on standard error");
  command.footer(footer);
  return [c] { return run(*c); };
}

} // namespace mdm::cli
