#include "sets/suite_members.hpp"

#include "text/nearest_name.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

std::string shown_json(const nlohmann::json &value) {
  return value.is_string() ? in_quotes(value.get_ref<const std::string &>())
                           : in_quotes(value.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace));
}

} // namespace

SuiteMembers::SuiteMembers(const nlohmann::json &object, std::string where)
    : object_(object), where_(std::move(where)) {
  if (!object.is_object())
    throw InputError((where_.empty() ? "the description" : where_) + " is no object: write {...}");
}

void SuiteMembers::refuse(const std::string &key, const std::string &what) const {
  throw InputError((where_.empty() ? "" : where_ + ": ") + key + ": " + what);
}

bool SuiteMembers::has(const char *key) {
  known_.insert(key);
  return object_.contains(key);
}

const nlohmann::json &SuiteMembers::value(const char *key) {
  if (!has(key))
    refuse(key, "is missing: see mdm suite --help");
  return object_[key];
}

std::string SuiteMembers::text(const char *key) {
  const nlohmann::json &member = value(key);
  if (!member.is_string())
    refuse(key, shown_json(member) + " is no text: write it in double quotes");
  return member.get<std::string>();
}

std::size_t SuiteMembers::word(const char *key, const std::vector<std::string> &words) {
  const std::string found = text(key);
  const auto place = std::find(words.begin(), words.end(), found);
  if (place == words.end())
    refuse(key, fmt::format("{} is none of {}", in_quotes(found), fmt::join(words, ", ")));
  return static_cast<std::size_t>(place - words.begin());
}

bool SuiteMembers::boolean(const char *key) {
  const nlohmann::json &member = value(key);
  if (!member.is_boolean())
    refuse(key, shown_json(member) + " is neither true nor false");
  return member.get<bool>();
}

Rational SuiteMembers::decimal(const char *key, const nlohmann::json &number,
                               const std::string &wrong) const {
  constexpr std::size_t longest = 100;
  if (!number.is_string())
    refuse(key, wrong);
  const std::string &text = number.get_ref<const std::string &>();
  if (text.size() > longest)
    refuse(key, fmt::format("{} is longer than {} characters: write fewer digits", in_quotes(text), longest));
  try {
    return parse_decimal(text);
  } catch (const InputError &e) {
    refuse(key, e.what());
  }
}

Rational SuiteMembers::positive(const char *key, const nlohmann::json &number) const {
  const Rational r = decimal(key, number, shown_json(number) + " is no number");
  if (r <= 0)
    refuse(key, shown_json(number) + " is not above 0");
  return r;
}

NumberRange SuiteMembers::numbers(const char *key, const Rational &least, const Rational &most) {
  const nlohmann::json &member = value(key);
  const bool is_range = member.is_array() && member.size() == 2;
  const auto number = [&](const nlohmann::json &written) {
    return decimal(key, written, shown_json(member) + " is neither a number nor [from, to]");
  };
  const NumberRange range = is_range ? NumberRange{number(member[0]), number(member[1])}
                                     : NumberRange{number(member), number(member)};
  if (range.from > range.to)
    refuse(key, shown_json(member) + " is upside down: write the smaller number first");
  if (range.from < least || range.to > most)
    refuse(key, fmt::format("{} is not from {} to {}", shown_json(member), approximate(least, 6),
                            approximate(most, 6)));
  return range;
}

CountRange SuiteMembers::counts(const char *key, std::uint32_t least, std::uint32_t most) {
  const NumberRange range = numbers(key, least, most);
  if (denominator(range.from) != 1 || denominator(range.to) != 1)
    refuse(key, shown_json(object_[key]) + ": write whole numbers");
  return {numerator(range.from).convert_to<std::uint32_t>(), numerator(range.to).convert_to<std::uint32_t>()};
}

std::uint32_t SuiteMembers::count(const char *key, std::uint32_t least, std::uint32_t most) {
  const CountRange range = counts(key, least, most);
  if (range.from != range.to)
    refuse(key, "write one number");
  return range.from;
}

void SuiteMembers::refuse_others() const {
  const std::vector<std::string_view> names(known_.begin(), known_.end());
  for (const auto &[key, member] : object_.items()) {
    if (known_.count(key) != 0)
      continue;
    const std::string_view nearest = nearest_name(key, names);
    throw InputError((where_.empty() ? "" : where_ + ": ") + in_quotes(key) + " is not known here" +
                     (nearest.empty() ? ": leave it out" : fmt::format(": did you mean {}?", nearest)));
  }
}

} // namespace mdm
