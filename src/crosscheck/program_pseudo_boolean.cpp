// An integer program for pseudo-Boolean solvers (OPB): each count is its least value and binary digits, x1,
// x2 and so on, the lowest first.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

std::string opb_terms(const BinaryDigits &digits, const Integer &coefficient) {
  std::string text;
  for (std::size_t d = 0; d < digits.count; ++d) {
    const Integer n = coefficient << static_cast<unsigned>(d);
    text += fmt::format("{}{} x{} ", n < 0 ? "" : "+", to_string(n), digits.first + d);
  }
  return text;
}

} // namespace

std::vector<BinaryDigits> binary_digits(const IntegerProgram &program) {
  std::vector<BinaryDigits> digits;
  std::size_t next = 1;
  for (const ProgramVariable &v : program.variables) {
    const Integer range = v.most.value() - v.least;
    digits.push_back({next, range == 0 ? 0 : static_cast<std::size_t>(msb(range)) + 1});
    next += digits.back().count;
  }
  return digits;
}

std::string pseudo_boolean_text(const IntegerProgram &program) {
  const std::vector<BinaryDigits> digits = binary_digits(program);
  std::string meaning, goal, bounds;
  Integer least = 0;
  std::size_t rows = program.rows.size();
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const ProgramVariable &v = program.variables[i];
    least += v.least;
    meaning += fmt::format("* {} = {}", v.name, to_string(v.least));
    for (std::size_t d = 0; d < digits[i].count; ++d)
      meaning += fmt::format(" + {} x{}", to_string(Integer(Integer(1) << static_cast<unsigned>(d))),
                             digits[i].first + d);
    meaning += "\n";
    goal += opb_terms(digits[i], 1);
    if (digits[i].count == 0)
      continue;
    bounds +=
        fmt::format("{}>= {} ;\n", opb_terms(digits[i], -1), to_string(Integer(v.least - v.most.value())));
    ++rows;
  }
  const std::size_t variables = digits.empty() ? 0 : digits.back().first + digits.back().count - 1;
  std::string text =
      fmt::format("* #variable= {} #constraint= {}\n", variables, rows) + comment_lines(program, "*") +
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
