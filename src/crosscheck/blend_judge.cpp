#include "crosscheck/blend_judge.hpp"

#include "answer/blend_problem_reader.hpp"
#include "answer/json_values.hpp"
#include "answer/string_members.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

using Json = nlohmann::json;

constexpr unsigned blend_digits = 12;
constexpr std::size_t shown_rows = 10;

std::vector<Rational> stated_shares(const Json &array, const char *key, const Rational &whole) {
  if (!array.is_array())
    throw InputError(fmt::format("{} is no array", key));
  std::vector<Rational> shares;
  for (const Json &value : array)
    shares.push_back(stated_number(value, fmt::format("{}[{}]", key, shares.size())) / whole);
  return shares;
}

/// The names of stockpiles, where they are stated: texts, or objects with a name.
std::vector<std::string> stated_stockpiles(const Json &array) {
  std::vector<std::string> names;
  for (const Json &stockpile : array)
    names.push_back(stockpile.is_string() ? stockpile.get<std::string>() : text_member(stockpile, "name"));
  return names;
}

std::string stated_status(const Json &object) {
  return has_member(object, "status") ? text_member(object, "status") : "";
}

bool says_there_is_none(const std::string &status) {
  return status == "none" || answer_verdict_named(status) == AnswerVerdict::infeasible;
}

/// Why an answer has no shares.
void take_failure(const Json &object, OtherBlend &answer) {
  const std::string status = stated_status(object);
  if (has_member(object, "reason"))
    answer.reason = text_member(object, "reason");
  const std::optional<AnswerVerdict> named = answer_verdict_named(status);
  if (says_there_is_none(status))
    answer.failure = AnswerVerdict::infeasible;
  else if (status == "gave up" || named == AnswerVerdict::gave_up)
    answer.failure = AnswerVerdict::gave_up;
  else if (named == AnswerVerdict::timeout || named == AnswerVerdict::crashed)
    answer.failure = named;
  else if (!status.empty())
    answer.failure = AnswerVerdict::no_answer;
  else
    throw InputError("there are neither \"shares\" nor \"percents\"");
}

/// A share as it was stated, where that is a decimal: rounded it may look like what it should be.
std::string stated_percent(const Rational &share) {
  const Rational percent = 100 * share;
  return exact_decimal(percent).value_or(approximate(percent, blend_digits));
}

/// Shares are in the order of the problem: an answer that names stockpiles names them so.
std::string fault_of_names(const BlendProblem &p, const std::vector<std::string> &names) {
  if (names.empty())
    return "";
  if (names.size() != p.stockpiles.size())
    return fmt::format("it names {} stockpiles, and there are {}", names.size(), p.stockpiles.size());
  for (std::size_t i = 0; i < names.size(); ++i)
    if (names[i] != p.stockpiles[i].name)
      return fmt::format(
          "its stockpile {} is {}, and that of the problem is {}: shares are in the problem's order", i + 1,
          in_quotes(names[i]), in_quotes(p.stockpiles[i].name));
  return "";
}

/// What is wrong with shares that are no blend of the problem; empty if nothing is.
std::string fault(const BlendProblem &p, const std::vector<Rational> &shares) {
  if (shares.size() != p.stockpiles.size())
    return fmt::format("it has {} shares, and there are {} stockpiles", shares.size(), p.stockpiles.size());
  std::size_t used = 0;
  Rational sum = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const std::string of = " of " + printable(p.stockpiles[i].name);
    if (shares[i] < 0)
      return "the share" + of + " is negative";
    if (denominator(Rational(shares[i] * p.steps)) != 1)
      return fmt::format("the share{} is {} %, no whole number of steps of {} %", of,
                         stated_percent(shares[i]), approximate(ratio(100, p.steps), blend_digits));
    if (shares[i] > 0)
      ++used;
    sum += shares[i];
  }
  if (sum != 1)
    return fmt::format("the shares sum to {} %", stated_percent(sum));
  if (p.at_most && used > *p.at_most)
    return fmt::format("{} stockpiles have a share, and {} may", used, *p.at_most);
  return "";
}

std::string blend_number(const std::optional<Rational> &r) {
  return r ? approximate(*r, blend_digits) : "";
}

} // namespace

OtherBlend json_blend(std::string_view text) {
  OtherBlend answer;
  try {
    const Json object = json_tree(text);
    if (!object.is_object())
      throw InputError("the answer is no JSON object");
    if (has_member(object, "id"))
      answer.id = text_member(object, "id");
    const bool has_shares = has_member(object, "shares") || has_member(object, "percents");
    if (has_shares && says_there_is_none(stated_status(object)))
      throw InputError("it has shares, and its status says that there is no blend");
    if (has_member(object, "stockpiles"))
      answer.stockpiles = stated_stockpiles(object["stockpiles"]);
    if (has_member(object, "shares") && has_member(object, "percents"))
      throw InputError("there are \"shares\" and \"percents\": write one of them");
    if (has_member(object, "shares"))
      answer.shares = stated_shares(object["shares"], "shares", 1);
    else if (has_member(object, "percents"))
      answer.shares = stated_shares(object["percents"], "percents", 100);
    else if (has_member(object, "blends") && object["blends"].is_array() && !object["blends"].empty())
      answer.shares = stated_shares(member_of(object["blends"][0], "shares"), "shares", 1);
    else
      take_failure(object, answer);
  } catch (const InputError &e) {
    answer.failure = AnswerVerdict::garbage;
    answer.reason = e.what();
  }
  return answer;
}

std::string_view name_of_blend(AnswerVerdict verdict) {
  switch (verdict) {
  case AnswerVerdict::minimal:
    return "best";
  case AnswerVerdict::larger:
    return "worse";
  case AnswerVerdict::not_a_match:
    return "not-a-blend";
  default:
    return name(verdict);
  }
}

BlendRow judge_blend(const std::string &id, const BlendProblem &problem, const BlendAnswer &found,
                     const OtherBlend &answer) {
  using Found = BlendAnswer::Status;
  BlendRow row;
  row.id = id;
  if (!found.best.empty())
    row.best = found.best.front().value;
  if (answer.failure) {
    row.verdict = *answer.failure;
    row.reason = answer.reason;
    if (row.verdict == AnswerVerdict::infeasible && found.status == Found::none) {
      row.verdict = AnswerVerdict::minimal;
      row.reason = "there is no blend, as it says";
    } else if (row.verdict == AnswerVerdict::infeasible && found.status == Found::unknown) {
      row.verdict = AnswerVerdict::undecided;
    }
    return row;
  }
  row.verdict = AnswerVerdict::not_a_match;
  row.reason = fault_of_names(problem, answer.stockpiles);
  if (row.reason.empty())
    row.reason = fault(problem, answer.shares);
  if (!row.reason.empty())
    return row;
  const Blend blend = blend_of(problem, answer.shares);
  row.value = blend.value;
  const std::vector<BlendLimit> broken = broken_limits(problem, blend);
  if (!broken.empty()) {
    std::vector<std::string> words;
    for (const BlendLimit &limit : broken)
      words.push_back(in_words(limit, problem));
    row.reason = fmt::format("it does not keep: {}", fmt::join(words, ", "));
    return row;
  }
  if (found.status != Found::optimal && blend.value > found.bound) {
    row.verdict = AnswerVerdict::undecided;
    row.reason = "a limit came before the best blend was known";
    return row;
  }
  const Rational least = found.status == Found::optimal ? found.best.front().value : found.bound;
  row.verdict = blend.value == least ? AnswerVerdict::minimal : AnswerVerdict::larger;
  return row;
}

void BlendSummary::add(const BlendRow &row) {
  ++counts_[static_cast<std::size_t>(row.verdict)];
  if (row.verdict != AnswerVerdict::minimal && first_others_.size() < shown_rows)
    first_others_.push_back(row);
}

std::uint64_t BlendSummary::rows() const {
  return std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0});
}

std::string BlendSummary::text() const {
  std::string text;
  for (const AnswerVerdict v : answer_verdicts)
    if (v <= AnswerVerdict::not_a_match || count(v) > 0)
      text += fmt::format("  {}: {}\n", name_of_blend(v), count(v));
  const std::uint64_t others = rows() - count(AnswerVerdict::minimal);
  if (others > 0)
    text += others > first_others_.size()
                ? fmt::format("\nnot the best, the first {} of {}:\n", first_others_.size(), others)
                : "\nnot the best:\n";
  for (const BlendRow &row : first_others_)
    text += fmt::format("  {}: {}{}{}\n", row.id.empty() ? "(no id)" : printable(row.id),
                        name_of_blend(row.verdict),
                        row.value && row.best && row.verdict == AnswerVerdict::larger
                            ? fmt::format(", {} for {}", blend_number(row.value), blend_number(row.best))
                            : "",
                        row.reason.empty() ? "" : ": " + printable(row.reason));
  return text;
}

std::string blend_rows_header() {
  return "id,verdict,value,best,reason\n";
}

std::string blend_row_csv(const BlendRow &row) {
  return fmt::format("{},{},{},{},{}\n", csv_field(row.id), name_of_blend(row.verdict),
                     blend_number(row.value), blend_number(row.best), csv_field(row.reason));
}

std::string blend_rows_json(const std::string &suite, const std::vector<BlendRow> &rows,
                            const BlendSummary &summary, const std::vector<std::string> &notes) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-crosscheck-blends-1").key("suite").string(suite);
  json.key("rows").begin_array();
  for (const BlendRow &row : rows) {
    json.begin_object().key("id").string(row.id).key("verdict").plain(name_of_blend(row.verdict));
    write(json.key("value"), row.value);
    write(json.key("best"), row.best);
    write_text(json.key("reason"), row.reason).end_object();
  }
  json.end_array().key("verdicts").begin_object();
  for (const AnswerVerdict v : answer_verdicts)
    json.key(name_of_blend(v)).number(summary.count(v));
  json.end_object().key("notes").strings(notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

} // namespace mdm
