// An integer program in MiniZinc, whose integers have 64 bits: no sum of terms may leave them.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

/// \throws InputError where a row can have values beyond 64 bits
void check_length(const ProgramRow &row, const IntegerProgram &program) {
  const Integer most = (Integer(1) << 63) - 1;
  Integer sum = abs(row.constant);
  for (const auto &[v, coefficient] : row.terms)
    sum += abs(coefficient) * program.variables[v].most.value();
  if (sum > most)
    throw InputError(
        "mzn: numbers of this program have more than 64 bits, which MiniZinc's integers have not: "
        "ask for smt2, or take the masses to fewer digits");
}

} // namespace

std::string minizinc_text(const IntegerProgram &program) {
  std::string text = comment_lines(program, "%"), counts, shown;
  for (std::size_t v = 0; v < program.variables.size(); ++v) {
    const ProgramVariable &variable = program.variables[v];
    text += fmt::format("var {}..{}: {};\n", to_string(variable.least), to_string(variable.most.value()),
                        variable.name);
    counts += (v == 0 ? "" : " + ") + variable.name;
    shown += fmt::format("{}\"{} = \\({});\\n\"", v == 0 ? "" : ", ", variable.name, variable.name);
  }
  for (const ProgramRow &row : program.rows) {
    check_length(row, program);
    text += "constraint ";
    for (std::size_t t = 0; t < row.terms.size(); ++t) {
      const auto &[v, coefficient] = row.terms[t];
      text +=
          fmt::format("{}{} * {}", t == 0 ? "" : " + ", to_string(coefficient), program.variables[v].name);
    }
    text += fmt::format(" >= {};\n", to_string(row.constant));
  }
  return text + "solve minimize " + counts + ";\noutput [" + shown + "];\n";
}

} // namespace mdm
