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
  bool is_starred = false; // by GLPK, once
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    if ((word == "(" && next_word(text, at) != ")") || (word == "*" && is_starred))
      return {};
    is_starred = is_starred || word == "*";
    if (word != "=" && word != ":" && word != "*" && word != "\"" && word != "'" && word != "Int" &&
        word != "(")
      return word;
  }
  return {};
}

/// The lines of the text, without spaces at their ends and with single ones between words.
std::vector<std::string> tidy_lines(std::string_view text) {
  std::vector<std::string> lines = {""};
  for (const char c : text) {
    if (c == '\n')
      lines.emplace_back();
    else if (std::isspace(static_cast<unsigned char>(c)) == 0)
      lines.back() += c;
    else if (!lines.back().empty() && lines.back().back() != ' ')
      lines.back() += ' ';
  }
  for (std::string &line : lines)
    if (!line.empty() && line.back() == ' ')
      line.pop_back();
  return lines;
}

/// True for a line of a table that begins with the name of a count, perhaps after its number.
bool begins_with_count(const std::string &line) {
  std::size_t at = 0;
  const std::string_view first = next_word(line, at);
  if (is_count_name(first))
    return true;
  return !first.empty() &&
         std::all_of(first.begin(), first.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
         is_count_name(next_word(line, at));
}

/// The last value of each count.
/// \throws InputError where a line is of a count and has no number
std::map<std::string, std::string> values_in(const std::vector<std::string> &lines) {
  std::map<std::string, std::string> values;
  std::string text;
  for (const std::string &line : lines)
    text += line + "\n";
  std::size_t line_end = 0, number = 0;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    while (line_end < at) // the line in which the word ends
      line_end += lines[number++].size() + 1;
    if (!is_count_name(word))
      continue;
    const std::string_view value = value_behind(text, at);
    if (begins_number(value))
      values[std::string(word)] = value;
    else if (begins_with_count(lines[number - 1]))
      throw InputError(
          fmt::format("{} has no number of particles in the line '{}'", word, lines[number - 1]));
  }
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
Integer count_of(const std::string &name, const std::string &value) {
  const Rational number = parse_decimal(value);
  if (denominator(number) != 1 || number < 0)
    throw InputError(fmt::format("{} = {} is no number of particles", name, value));
  return numerator(number);
}

/// The values in the lines that begin with `v `, true or false, of the last solution: one begins where x1
/// comes again.
std::map<std::string, bool> binary_values(const std::vector<std::string> &lines) {
  std::map<std::string, bool> values;
  for (const std::string &line : lines) {
    if (!line.starts_with("v "))
      continue;
    std::size_t at = 2;
    for (std::string_view word = next_word(line, at); !word.empty(); word = next_word(line, at)) {
      const bool is_true = word[0] != '-';
      const std::string name(is_true ? word : word.substr(1));
      if (name == "x1")
        values.clear();
      if (name != "0") // the end of some lines
        values[name] = is_true;
    }
  }
  return values;
}

/// \throws InputError where a digit has no value, or one is of another problem
std::vector<Integer> counts_of_digits(std::map<std::string, bool> values, const IntegerProgram &program) {
  const std::vector<BinaryDigits> digits = binary_digits(program);
  std::vector<Integer> counts;
  for (std::size_t j = 0; j < program.counts; ++j) {
    Integer count = program.variables[j].least;
    for (std::size_t d = 0; d < digits[j].count; ++d) {
      const auto value = values.extract(fmt::format("x{}", digits[j].first + d));
      if (value.empty())
        throw InputError(
            fmt::format("x{} has no value: the solution is cut, or of another problem", digits[j].first + d));
      if (value.mapped())
        count += Integer(1) << static_cast<unsigned>(d);
    }
    counts.push_back(count);
  }
  if (!values.empty())
    throw InputError(values.begin()->first + " is no digit of this problem: the solution is of another one");
  return counts;
}

/// True if a line, whatever its case, begins with one of the texts; with `whole` it is one.
bool says(const std::vector<std::string> &lines, const std::vector<std::string> &texts, bool whole) {
  return std::any_of(lines.begin(), lines.end(), [&](std::string line) {
    std::transform(line.begin(), line.end(), line.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(texts.begin(), texts.end(), [&](const std::string &text) {
      return whole ? line == text : line.starts_with(text);
    });
  });
}

bool says_infeasible(const std::vector<std::string> &lines) {
  return says(lines,
              {"unsat", "s unsatisfiable", "=====unsatisfiable=====", "infeasible",
               "this problem is infeasible"},
              true) ||
         says(lines,
              {"infeasible - ", "integer infeasible", "status: integer empty", "solution status: infeasible",
               "model status : infeasible"},
              false);
}

bool says_unknown(const std::vector<std::string> &lines) {
  return says(lines,
              {"unknown", "s unknown", "=====unknown=====", "status: integer undefined", "status: undefined"},
              true) ||
         says(lines, {"stopped on "}, false);
}

/// True for lines of a pseudo-Boolean solver that has a solution.
bool is_pseudo_boolean(const std::vector<std::string> &lines) {
  return !binary_values(lines).empty() || says(lines, {"s optimum found", "s satisfiable"}, true);
}

} // namespace

bool has_binary_values(std::string_view text) {
  return is_pseudo_boolean(tidy_lines(text));
}

Solution read_solution(std::string_view text, const IntegerProgram &program) {
  const std::vector<std::string> lines = tidy_lines(text);
  const auto none = [&program](AnswerVerdict verdict, const std::string &reason) {
    return Solution{failed_answer(program.id, verdict, reason), {}};
  };
  if (says_infeasible(lines))
    return none(AnswerVerdict::infeasible, "the solver says that there is no solution");
  try {
    Solution solution;
    solution.answer.id = program.id;
    if (is_pseudo_boolean(lines)) {
      solution.answer.quantities = counts_of_digits(binary_values(lines), program);
      return solution;
    }
    const std::map<std::string, std::string> values = values_in(lines);
    if (values.empty() && says_unknown(lines))
      return none(AnswerVerdict::gave_up, "the solver says that it found none");
    if (values.empty())
      return none(AnswerVerdict::garbage,
                  "no value of a count such as q1 is in the file; of GLPK give what -o writes");
    solution.answer.quantities.assign(program.counts, 0);
    for (const auto &[name, value] : values)
      solution.answer.quantities[place_of(name, program)] = count_of(name, value);
    for (std::size_t j = 0; j < program.counts; ++j)
      if (!values.contains(program.variables[j].name))
        solution.notes.push_back(program.variables[j].name + " is not in the solution: it is taken as 0");
    return solution;
  } catch (const InputError &e) {
    return none(AnswerVerdict::garbage, e.what());
  }
}

} // namespace mdm
