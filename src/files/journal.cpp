#include "files/journal.hpp"

#include "crosscheck/journal_line.hpp"
#include "files/paths.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <limits>

namespace mdm {

Journal::Journal(std::string path, std::string solver) : file_(std::move(path)), solver_(std::move(solver)) {
  file_.read([this](std::string_view line, std::size_t number) { take(line, number); },
             "is no journal of mdm crosscheck: name a new file");
}

void Journal::take(std::string_view text, std::size_t number) {
  OtherAnswer answer = json_answer(text);
  const auto solver = answer.labels.find(journal_label::solver);
  const auto line = answer.labels.find(journal_label::line);
  const std::optional<Integer> at = line == answer.labels.end() ? std::nullopt : parse_natural(line->second);
  if (!at || *at > std::numeric_limits<std::uint64_t>::max() || solver == answer.labels.end())
    throw file_error(line_name(file_.path(), number),
                     "is no line of a journal of mdm crosscheck: name a new file");
  const auto gradation = answer.labels.find(journal_label::gradation);
  if (gradation == answer.labels.end())
    throw file_error(line_name(file_.path(), number),
                     "does not say which gradation was asked, as journals of version 1 do not: name a new "
                     "file (this one is still good as ANSWERS)");
  if (solver->second == solver_)
    answers_[static_cast<std::uint64_t>(*at)] = {gradation->second, std::move(answer)};
}

const OtherAnswer *Journal::find(std::uint64_t line, const Gradation &g) const {
  const auto found = answers_.find(line);
  if (found == answers_.end())
    return nullptr;
  const auto &[gradation, answer] = found->second;
  if (answer.id != g.id())
    throw file_error(file_.path(),
                     fmt::format("has an answer for {} where the suite's line {} has {}: the suite is "
                                 "another one; name a new file",
                                 in_quotes(answer.id), line, in_quotes(g.id())));
  return gradation == digest(g) ? &answer : nullptr;
}

void Journal::add(std::uint64_t line, const Gradation &g, const OtherAnswer &answer) {
  file_.add(answer_line(answer, {{journal_label::solver, solver_},
                                 {journal_label::line, std::to_string(line)},
                                 {journal_label::gradation, digest(g)}}));
}

} // namespace mdm
