// The answers of a file by the id of their gradation. Settings, the values of a label that users group by,
// are found in one pass; then each gradation asks for its answers and gets a row for each setting,
// `no-answer` where it has none. What was asked is noted in flags that several threads may set, so that in
// the end answers to nothing, ids with several answers, and answers to gradations that were corrected since
// can be told.

#include "crosscheck/answer_index.hpp"

#include "crosscheck/journal_line.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <set>

namespace mdm {

AnswerIndex::AnswerIndex(std::vector<OtherAnswer> answers, std::optional<std::string> by)
    : answers_(std::move(answers)), is_judged_(answers_.size()), by_(std::move(by)) {
  const auto has_label = [this](const OtherAnswer &a) { return a.labels.count(*by_) > 0; };
  if (by_ && std::none_of(answers_.begin(), answers_.end(), has_label))
    throw InputError(
        fmt::format("no answer has {}; {}", in_quotes(*by_),
                    labels().empty() ? "there is nothing to group them by" : "they have " + labels()));
  for (std::size_t i = 0; i < answers_.size(); ++i) {
    const OtherAnswer &answer = answers_[i];
    asked_.push_back(asked_digest(answer));
    (answer.has_id ? by_id_[answer.id].answers : without_id_).push_back(i);
    if (answer.failure != AnswerVerdict::garbage && place(setting_of(answer)) == settings_.size())
      settings_.push_back(setting_of(answer));
  }
  if (settings_.empty())
    settings_.emplace_back();
}

std::string AnswerIndex::setting_of(const OtherAnswer &answer) const {
  const auto label = by_ ? answer.labels.find(*by_) : answer.labels.end();
  return label == answer.labels.end() ? "" : label->second;
}

/// Position among the settings, or their number.
std::size_t AnswerIndex::place(const std::string &setting) const {
  return static_cast<std::size_t>(std::find(settings_.begin(), settings_.end(), setting) - settings_.begin());
}

std::vector<CrosscheckRow> AnswerIndex::judge(const Crosscheck &problem, const Rational &size_tolerance,
                                              const std::function<void(const OtherAnswer &)> &seen) const {
  std::vector<CrosscheckRow> rows;
  const auto add = [&](const OtherAnswer &answer, const std::string &setting) {
    rows.push_back(problem.judge(answer, size_tolerance));
    rows.back().setting = setting;
  };
  // By setting; the last one: garbage of none.
  std::vector<bool> answered(settings_.size() + 1), outdated(settings_.size() + 1);
  const auto found = by_id_.find(problem.gradation().id());
  if (found != by_id_.end()) {
    found->second.asked = true;
    for (const std::size_t i : found->second.answers) {
      const std::string setting = setting_of(answers_[i]);
      if (asked_[i] && *asked_[i] != digest(problem.gradation())) {
        outdated[place(setting)] = true;
        continue;
      }
      is_judged_[i] = true;
      add(answers_[i], setting);
      if (seen)
        seen(answers_[i]);
      answered[place(setting)] = true;
    }
  }
  for (std::size_t s = 0; s < settings_.size(); ++s)
    if (!answered[s])
      add(failed_answer("", AnswerVerdict::no_answer,
                        outdated[s] ? "the journal's answer is to another gradation with this id: ask again"
                                    : "there is none with this id"),
          settings_[s]);
  std::stable_sort(rows.begin(), rows.end(), [this](const CrosscheckRow &a, const CrosscheckRow &b) {
    return place(a.setting) < place(b.setting);
  });
  return rows;
}

std::vector<CrosscheckRow> AnswerIndex::rows_without_id() const {
  std::vector<CrosscheckRow> rows;
  for (const std::size_t i : without_id_) {
    CrosscheckRow &row = rows.emplace_back();
    row.setting = setting_of(answers_[i]);
    row.verdict = AnswerVerdict::garbage;
    row.reason = answers_[i].failure == AnswerVerdict::garbage ? answers_[i].reason : "the answer has no id";
  }
  return rows;
}

/// `'iterations', 'x_n_factor'`, or nothing.
std::string AnswerIndex::labels() const {
  std::set<std::string> names;
  for (const OtherAnswer &answer : answers_)
    for (const auto &[name, value] : answer.labels)
      names.insert(name);
  std::string text;
  for (const std::string &name : names)
    text += (text.empty() ? "" : ", ") + in_quotes(name);
  return text;
}

/// True if the suite has the answer's id, but not what was asked under it.
bool AnswerIndex::is_outdated(const Entry &entry, std::size_t i) const {
  return entry.asked && asked_[i] && !is_judged_[i];
}

bool AnswerIndex::has_several(const Entry &entry) const {
  std::set<std::pair<std::string, std::optional<std::string>>> seen;
  return std::any_of(entry.answers.begin(), entry.answers.end(), [&](std::size_t i) {
    return !is_outdated(entry, i) && !seen.emplace(setting_of(answers_[i]), asked_[i]).second;
  });
}

std::vector<std::string> AnswerIndex::notes() const {
  std::vector<std::string> strangers, corrected;
  std::size_t several = 0, outdated = 0;
  for (const auto &[id, entry] : by_id_) {
    if (!entry.asked)
      strangers.push_back(id);
    if (has_several(entry))
      ++several;
    const auto old = std::count_if(entry.answers.begin(), entry.answers.end(),
                                   [&, &e = entry](std::size_t i) { return is_outdated(e, i); });
    if (old > 0)
      corrected.push_back(id);
    outdated += static_cast<std::size_t>(old);
  }
  std::vector<std::string> notes;
  if (!strangers.empty())
    notes.push_back(fmt::format("the suite has no gradation for {} of the ids that have answers, such as {}",
                                strangers.size(),
                                in_quotes(*std::min_element(strangers.begin(), strangers.end()))));
  if (several > 0)
    notes.push_back(fmt::format(
        "{} ids have several answers{}; each is a row{}", several, by_ ? " of one setting" : "",
        by_ || labels().empty() ? "" : ": tell them apart with " + option("by") + ", by " + labels()));
  if (outdated > 0)
    notes.push_back(
        fmt::format("{} answers of the journal are to other gradations than the suite has under their ids "
                    "now, such as {}, and are not judged: ask again, with {} and {}",
                    outdated, in_quotes(*std::min_element(corrected.begin(), corrected.end())),
                    option("solver"), option("journal")));
  return notes;
}

} // namespace mdm
