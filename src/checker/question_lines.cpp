#include "question_lines.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace mdm::checker {

void QuestionLines::read(std::string_view name, std::string_view kinds, Numbers &numbers, bool repeat) {
  demand(name);
  do
    for (const char kind : kinds)
      numbers.push_back(kind == 'f' ? Number{0, word()} : number(kind));
  while (repeat && more());
  check(numbers.size() <= 3 * most_classes, "more numbers than there are sieves: give fewer");
  end();
}

void QuestionLines::read_if_there(std::string_view name, std::string_view kinds, Numbers &numbers,
                                  bool repeat) {
  if (begins_with(name) && begins_with(std::string(name) + " file") == (kinds == "f"))
    read(name, kinds, numbers, repeat);
}

Number QuestionLines::number(char kind, std::string_view text) {
  const auto form = static_cast<char>(std::tolower(kind));
  const bool is_percent = form == 'p' || form == 't', is_rational = form == 'r' || form == 'q';
  const mpq_class value = is_rational ? read_rational(text, line_)
                                      : read_canonical(text, line_, form == 'd' || form == 'z' || is_percent);
  const bool enough =
      is_digit(kind) ? value >= kind - '0' : value > 0 || form == 'z' || form == 'q' || is_percent;
  demand_form(enough, line_, "is too small: raise it, or leave out a line that says nothing", text);
  demand_form(form != 'p' || value <= 100, line_, "is more than 100 percentage points: lower it", text);
  demand_form(form != 't' || value <= 200, line_, "is more than 200 percentage points: lower it", text);
  if (kind != form || is_digit(kind))
    longest_count_ = std::max(longest_count_, bits(value));
  return {value, text};
}

std::uint64_t QuestionLines::index(std::string_view text) const {
  std::uint64_t value = 0;
  const char *const end = text.data() + text.size();
  const bool read = std::from_chars(text.data(), end, value).ptr == end;
  demand_form(read && (text.size() == 1 || (!text.empty() && text[0] != '0')) && text.size() <= 18, line_,
              "is no index: write an integer of at most 18 digits", text);
  return value;
}

namespace {

/// The nodes of a table ascend from (0, 0), the exponents of a sum descend.
void read_law_by_values(QuestionLines &lines, Certificate &c) {
  const bool is_table = lines.begins_with("law table");
  Numbers &numbers = is_table ? c.nodes : c.terms;
  lines.read(is_table ? "law table" : "law sum", is_table ? "DD" : "R1", numbers, true);
  lines.check_before(numbers.size() <= 2 * (is_table ? most_nodes : most_terms),
                     "a law of more than 1000 nodes or 16 terms: choose a simpler one");
  c.law_work = is_table ? work_of_table : 0;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    const Number *const before = i == 0 ? nullptr : &numbers[i - 2];
    if (is_table) {
      lines.check_before(before == nullptr ||
                             (before[0].value < numbers[i].value && before[1].value < numbers[i + 1].value),
                         "a table whose sizes and masses do not ascend: sort its nodes");
      continue;
    }
    const mpq_class &exponent = numbers[i + 1].value;
    lines.check_before(exponent <= 1000 && (before == nullptr || exponent < before[1].value),
                       "a sum whose exponents do not descend from 1000 at most: sort its terms");
    c.law_work += exponent.get_num().get_ui();
  }
  c.law = {{1, numbers[0].text}};
  c.a = c.b = 1;
}

void read_law(QuestionLines &lines, Certificate &c) {
  if (lines.begins_with("law table") || lines.begins_with("law sum"))
    return read_law_by_values(lines, c);
  lines.read("law", "r", c.law);
  const mpq_class &law = c.law[0].value;
  lines.check_before(law.get_num() <= 1000 && law.get_den() <= 1000,
                     "a law with numbers above 1000: choose a simpler one");
  c.a = law.get_num().get_ui();
  c.b = law.get_den().get_ui();
  c.law_work = std::max(c.a, c.b);
}

} // namespace

void read_law_and_openings(QuestionLines &lines, Certificate &c) {
  read_law(lines, c);
  lines.read_if_there("pan-size", "d", c.pan_size);
  lines.read_if_there("cut-below", "d", c.cut_below);
  lines.read_if_there("size-factor", "d", c.size_factor);
  lines.check_before(c.size_factor.empty() || c.size_factor[0].value != 1,
                     "a factor of 1 says nothing: leave it out");
}

bool read_tolerance(QuestionLines &lines, Certificate &c) {
  const char *const begin = lines.here();
  lines.read_if_there("retained", "P", c.retained);
  lines.read_if_there("retained", "f", c.retained_file);
  lines.read_if_there("passing", "P", c.passing);
  lines.read_if_there("passing", "f", c.passing_file);
  lines.read_if_there("passing-each", "P", c.passing_each, true);
  lines.read_if_there("total", "T", c.total);
  lines.read_if_there("band", "f", c.band_file);
  for (std::size_t i = 0; c.band_file.empty() && lines.begins_with("band"); i += 3) {
    lines.read("band", "ZZZ", c.band);
    lines.check_before(i == 0 || c.band[i - 3].value < c.band[i].value,
                       "sieves of a band that do not ascend: sort them");
  }
  return lines.here() != begin;
}

} // namespace mdm::checker
