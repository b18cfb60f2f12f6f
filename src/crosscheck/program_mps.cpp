// An integer program in free MPS, column by column. Every integer variable has its bounds: where there are
// none, some readers take 1 for the upper one.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>

#include <fmt/format.h>

namespace mdm {

std::string mps_text(const IntegerProgram &program) {
  std::vector<std::string> columns(program.variables.size());
  for (std::size_t v = 0; v < columns.size(); ++v)
    if (v < program.counts)
      columns[v] = fmt::format(" {} particles 1\n", program.variables[v].name);
  for (const ProgramRow &row : program.rows)
    for (const auto &[v, coefficient] : row.terms)
      columns[v] += fmt::format(" {} {} {}\n", program.variables[v].name, row.name, to_string(coefficient));
  std::string text = comment_lines(program, "*") + "NAME mdm\nROWS\n N particles\n";
  for (const ProgramRow &row : program.rows)
    text += " G " + row.name + "\n";
  text += "COLUMNS\n MARKER 'MARKER' 'INTORG'\n";
  for (std::size_t v = 0; v < columns.size(); ++v) {
    if (v == program.counts)
      text += " MARKER 'MARKER' 'INTEND'\n";
    text += columns[v];
  }
  if (program.counts == columns.size())
    text += " MARKER 'MARKER' 'INTEND'\n";
  text += "RHS\n";
  for (const ProgramRow &row : program.rows)
    if (row.constant != 0)
      text += fmt::format(" RHS {} {}\n", row.name, to_string(row.constant));
  text += "BOUNDS\n";
  for (const ProgramVariable &v : program.variables)
    // CBC takes lines with a shorter name for those of MPS with fixed columns.
    text += fmt::format(" LO BOUNDSET1 {} {}\n PL BOUNDSET1 {}\n", v.name, to_string(v.least), v.name);
  return text + "ENDATA\n";
}

} // namespace mdm
