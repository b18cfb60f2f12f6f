#include "cli/crosscheck_blends.hpp"

#include "cli/exit_code.hpp"
#include "cli/interrupted.hpp"
#include "crosscheck/blend_judge.hpp"
#include "files/blend_lines.hpp"
#include "files/in_parallel.hpp"
#include "files/interrupt.hpp"
#include "files/output.hpp"
#include "files/solver.hpp"
#include "number/counted.hpp"
#include "text/file_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace mdm::cli {
namespace {

using BlendRows = std::vector<BlendRow>;

/// Problems alone: nothing is run or written where a line is bad.
std::vector<BlendLine> problems_in(FileLines &lines, const std::string &path) {
  std::vector<BlendLine> problems = read_blend_lines(lines, path);
  for (const BlendLine &line : problems)
    if (!line.problem)
      throw file_error(line.where, line.error);
  return problems;
}

/// The answers of a file, by the problem that they are for.
class BlendAnswers {
public:
  explicit BlendAnswers(const std::string &path) {
    FileLines lines(path);
    for (std::vector<FileLines::Line> next = lines.next(1); !next.empty(); next = lines.next(1)) {
      if (FileLines::is_blank(next.front()))
        continue;
      OtherBlend answer = json_blend(next.front().value_or(""));
      by_id_[answer.id].push_back(std::move(answer));
    }
  }

  const std::vector<OtherBlend> &of(const std::string &id) const {
    static const std::vector<OtherBlend> none;
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? none : found->second;
  }

  /// The ids that no problem has; answers without one have an empty id.
  std::vector<std::string> strangers(const std::vector<BlendLine> &problems) const {
    std::vector<std::string> ids;
    for (const auto &[id, answers] : by_id_)
      if (std::none_of(problems.begin(), problems.end(),
                       [&of = id](const BlendLine &p) { return p.id == of; }))
        ids.push_back(id);
    return ids;
  }

private:
  std::map<std::string, std::vector<OtherBlend>> by_id_;
};

/// The answer of the solver, which is given the line of the problem.
OtherBlend solved_by(const CrosscheckBlends &c, const BlendLine &line) {
  const ProgramAnswer said = ask_program(*c.solver, line.text + "\n", c.time_limit);
  if (said.failure)
    return {line.id, said.failure, said.reason, {}};
  OtherBlend answer = json_blend(said.text);
  if (!answer.id.empty() && answer.id != line.id)
    return {line.id, AnswerVerdict::garbage, "the answer is for " + in_quotes(answer.id), {}};
  return answer;
}

std::string csv(const BlendRows &rows) {
  std::string text = blend_rows_header();
  for (const BlendRow &row : rows)
    text += blend_row_csv(row);
  return text;
}

std::string text(const std::string &suite, std::size_t problems, const BlendSummary &summary,
                 const std::vector<std::string> &notes) {
  std::string all = fmt::format("{}: {}, {}\n\n", printable(suite), counted(problems, "problem"),
                                counted(summary.rows(), "answer")) +
                    summary.text();
  for (const std::string &note : notes)
    all += "  note: " + note + "\n";
  return all;
}

int exit_of(const BlendSummary &summary, bool require_best) {
  const std::uint64_t good =
      summary.count(AnswerVerdict::minimal) + (require_best ? 0 : summary.count(AnswerVerdict::larger));
  const std::uint64_t open = summary.count(AnswerVerdict::undecided);
  return good + open < summary.rows() ? Exit::negative : open > 0 ? Exit::limited : Exit::done;
}

} // namespace

int crosscheck_blends(FileLines &lines, const CrosscheckBlends &c) {
  const std::vector<BlendLine> problems = problems_in(lines, c.suite);
  std::optional<BlendAnswers> answers;
  if (c.answers)
    answers.emplace(*c.answers);
  std::vector<BlendRow> rows;
  BlendSummary summary;
  const auto add = [&](const BlendRows &judged) {
    for (const BlendRow &row : judged) {
      rows.push_back(row);
      summary.add(row);
    }
  };
  std::optional<Interrupt> interrupt;
  if (!c.solver) // whose run Ctrl-C ends on the spot
    interrupt.emplace();
  BlendOptions search;
  search.go_on = [] { return !Interrupt::was_pressed(); };
  const std::size_t done = in_order<BlendRows>(
      problems.size(), c.threads,
      [&](std::size_t i) {
        const BlendLine &line = problems[i];
        const BlendAnswer best = in_file(line.where, [&] { return solve_blend(*line.problem, search); });
        std::vector<OtherBlend> given;
        if (answers)
          given = answers->of(line.id);
        else
          given.push_back(solved_by(c, line));
        if (given.empty())
          given.push_back({line.id, AnswerVerdict::no_answer, "there is none with this id", {}});
        BlendRows judged;
        for (const OtherBlend &answer : given)
          judged.push_back(judge_blend(line.id, *line.problem, best, answer));
        return judged;
      },
      add, Interrupt::was_pressed);
  const bool is_whole = done == problems.size();
  std::vector<std::string> notes;
  if (!is_whole)
    notes.push_back(interrupted_after(done, "problem"));
  else if (answers) {
    for (const OtherBlend &answer : answers->of(""))
      add({{"",
            AnswerVerdict::garbage,
            {},
            {},
            answer.reason.empty() ? "the answer has no id" : answer.reason}});
    for (const std::string &id : answers->strangers(problems))
      if (!id.empty())
        notes.push_back("There is no problem " + in_quotes(id) + ", which has an answer.");
  }
  Output out(c.output.path());
  out.write(c.output.report([&] { return text(shown_name(c.suite), done, summary, notes); },
                            [&] { return blend_rows_json(shown_name(c.suite), rows, summary, notes); },
                            [&] { return csv(rows); }));
  c.output.tell_notes_beside_csv(notes);
  out.commit();
  const int exit = exit_of(summary, c.require_best);
  return is_whole ? exit : worse_exit(exit, Exit::limited);
}

} // namespace mdm::cli
