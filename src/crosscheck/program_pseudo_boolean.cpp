// An integer program for pseudo-Boolean solvers (OPB): each count is its least value and binary digits, x1,
// x2 and so on, the lowest first.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// Where the digits of a count are: x`first` and those behind it.
struct Digits {
  std::size_t first, count;
};

std::string opb_terms(const Digits &digits, const Integer &coefficient) {
  std::string text;
  for (std::size_t d = 0; d < digits.count; ++d) {
    const Integer n = coefficient << static_cast<unsigned>(d);
    text += fmt::format("{}{} x{} ", n < 0 ? "" : "+", to_string(n), digits.first + d);
  }
  return text;
}

} // namespace

std::string pseudo_boolean_text(const IntegerProgram &program) {
  std::vector<Digits> digits;
  std::size_t next = 1;
  std::string meaning, goal, bounds;
  Integer least = 0;
  std::size_t rows = program.rows.size();
  for (const ProgramVariable &v : program.variables) {
    const Integer range = v.most.value() - v.least;
    digits.push_back({next, range == 0 ? 0 : static_cast<std::size_t>(msb(range)) + 1});
    next += digits.back().count;
    least += v.least;
    meaning += fmt::format("* {} = {}", v.name, to_string(v.least));
    for (std::size_t d = 0; d < digits.back().count; ++d)
      meaning += fmt::format(" + {} x{}", to_string(Integer(Integer(1) << static_cast<unsigned>(d))),
                             digits.back().first + d);
    meaning += "\n";
    goal += opb_terms(digits.back(), 1);
    if (range == 0)
      continue;
    bounds += fmt::format("{}>= {} ;\n", opb_terms(digits.back(), -1), to_string(Integer(-range)));
    ++rows;
  }
  std::string text =
      fmt::format("* #variable= {} #constraint= {}\n", next - 1, rows) + comment_lines(program, "*") +
      meaning +
      fmt::format("* The particles are {} more than the sum that is minimised.\n", to_string(least)) +
      "min: " + goal + ";\n" + bounds;
  for (const ProgramRow &row : program.rows) {
    Integer constant = row.constant;
    for (const auto &[v, coefficient] : row.terms) {
      text += opb_terms(digits[v], coefficient);
      constant -= coefficient * program.variables[v].least;
    }
    text += fmt::format(">= {} ;\n", to_string(constant));
  }
  return text;
}

} // namespace mdm
