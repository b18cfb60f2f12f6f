// Solutions of integer programs. A text becomes words (names, numbers, and marks between them). A number is
// the value of a name if nothing but marks of a few kinds stands between them: so names in a sum that a
// solver repeats have none. Where a name has several values the last counts, as solvers print what they find
// on the way.

#include "crosscheck/solution_reader.hpp"

#include "crosscheck/program_text.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace mdm {
namespace {

bool is_name_character(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '+' || c == '-';
}

/// The next word at or after `at`: a run of characters of names and numbers, or a mark. Empty at the end.
std::string_view next_word(std::string_view text, std::size_t &at) {
  while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) != 0)
    ++at;
  const std::size_t begin = at;
  while (at < text.size() && is_name_character(text[at]))
    ++at;
  if (at == begin && at < text.size())
    ++at;
  return text.substr(begin, at - begin);
}

/// `q12`.
bool is_count_name(std::string_view word) {
  return word.size() > 1 && word[0] == 'q' && word[1] != '0' &&
         std::all_of(word.begin() + 1, word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

bool begins_number(std::string_view word) {
  return !word.empty() && (std::isdigit(static_cast<unsigned char>(word[0])) != 0 ||
                           ((word[0] == '-' || word[0] == '+') && word.size() > 1));
}

/// The word behind a name that may be its value: after `=`, `:`, `*`, quotes, the word Int or a pair of
/// brackets.
std::string_view value_behind(std::string_view text, std::size_t at) {
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    if (word == "(" && next_word(text, at) != ")")
      return {};
    if (word != "=" && word != ":" && word != "*" && word != "\"" && word != "'" && word != "Int" &&
        word != "(")
      return word;
  }
  return {};
}

/// The last value of each count.
std::map<std::string, std::string_view> values_in(std::string_view text) {
  std::map<std::string, std::string_view> values;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at))
    if (is_count_name(word))
      if (const std::string_view value = value_behind(text, at); begins_number(value))
        values[std::string(word)] = value;
  return values;
}

/// The place of a count in the program. \throws InputError where it has none of that name
std::size_t place_of(const std::string &name, const IntegerProgram &program) {
  for (std::size_t j = 0; j < program.counts; ++j)
    if (program.variables[j].name == name)
      return j;
  throw InputError(name + " is no count of this problem: the solution is of another one");
}

/// \throws InputError where it is no whole number from 0 on
Integer count_of(const std::string &name, std::string_view value) {
  const Rational number = parse_decimal(value);
  if (denominator(number) != 1 || number < 0)
    throw InputError(fmt::format("{} = {} is no number of particles", name, value));
  return numerator(number);
}

/// The lines that begin with `v `, without it.
std::vector<std::string_view> value_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = text.substr(begin, end - begin);
    if (line.starts_with("v "))
      lines.push_back(line.substr(2));
    begin = end + 1;
  }
  return lines;
}

/// The counts of the digits that are true, of the last solution: one begins where x1 comes again.
std::vector<Integer> counts_of_digits(std::string_view text, const IntegerProgram &program) {
  std::set<std::string, std::less<>> is_true;
  for (const std::string_view line : value_lines(text)) {
    std::size_t at = 0;
    for (std::string_view word = next_word(line, at); !word.empty(); word = next_word(line, at)) {
      const bool is_false = word[0] == '-';
      if ((is_false ? word.substr(1) : word) == "x1")
        is_true.clear();
      if (!is_false)
        is_true.emplace(word);
    }
  }
  const std::vector<BinaryDigits> digits = binary_digits(program);
  std::vector<Integer> counts;
  for (std::size_t j = 0; j < program.counts; ++j) {
    Integer count = program.variables[j].least;
    for (std::size_t d = 0; d < digits[j].count; ++d)
      if (is_true.contains("x" + std::to_string(digits[j].first + d)))
        count += Integer(1) << static_cast<unsigned>(d);
    counts.push_back(count);
  }
  return counts;
}

bool says_infeasible(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.find("infeasible") != std::string::npos || lower.find("unsat") != std::string::npos;
}

} // namespace

bool has_binary_values(std::string_view text) {
  return !value_lines(text).empty();
}

OtherAnswer solution_answer(std::string_view text, const IntegerProgram &program) {
  OtherAnswer answer;
  answer.id = program.id;
  try {
    const std::map<std::string, std::string_view> values = values_in(text);
    if (values.empty() && has_binary_values(text)) {
      answer.quantities = counts_of_digits(text, program);
      return answer;
    }
    if (values.empty())
      return says_infeasible(text)
                 ? failed_answer(program.id, AnswerVerdict::infeasible,
                                 "the solver says that there is no solution")
                 : failed_answer(program.id, AnswerVerdict::garbage, "no value of q1 is in the file");
    answer.quantities.assign(program.counts, 0);
    for (const auto &[name, value] : values)
      answer.quantities[place_of(name, program)] = count_of(name, value);
    return answer;
  } catch (const InputError &e) {
    return failed_answer(program.id, AnswerVerdict::garbage, e.what());
  }
}

} // namespace mdm
