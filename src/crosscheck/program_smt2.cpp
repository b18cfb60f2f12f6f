// An integer program in SMT-LIB: strict inequalities and numbers of any length are what they are.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

std::string smt2_number(const Integer &n) {
  return n < 0 ? "(- " + to_string(Integer(-n)) + ")" : to_string(n);
}

/// What variables of type Int are in a sum of type Real.
std::string smt2_sum(const ProgramRow &row, const IntegerProgram &program) {
  std::string text;
  for (const auto &[v, coefficient] : row.terms) {
    const ProgramVariable &variable = program.variables[v];
    text += fmt::format(" (* {} {})", smt2_number(coefficient),
                        variable.is_integer ? "(to_real " + variable.name + ")" : variable.name);
  }
  return row.terms.size() == 1 ? text.substr(1) : "(+" + text + ")";
}

} // namespace

std::string smt2_text(const IntegerProgram &program) {
  std::string text = comment_lines(program, ";"), counts;
  for (const ProgramVariable &v : program.variables)
    text += fmt::format("(declare-const {} {})\n(assert (>= {} {}))\n", v.name, v.is_integer ? "Int" : "Real",
                        v.name, smt2_number(v.least));
  for (const ProgramRow &row : program.rows) {
    std::string holds = fmt::format("({} {} {})", row.is_strict ? ">" : ">=", smt2_sum(row, program),
                                    smt2_number(row.constant));
    if (row.where)
      holds = fmt::format("(=> (>= {} 1) {})", program.variables[*row.where].name, holds);
    text += fmt::format("(assert (! {} :named {}))\n", holds, row.name);
  }
  for (std::size_t j = 0; j < program.counts; ++j)
    counts += " " + program.variables[j].name;
  const std::string sum = program.counts == 1 ? counts.substr(1) : "(+" + counts + ")";
  return text + "(minimize " + sum + ")\n(check-sat)\n(get-objectives)\n(get-value (" + counts.substr(1) +
         "))\n";
}

} // namespace mdm
