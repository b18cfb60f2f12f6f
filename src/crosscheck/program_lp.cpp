// An integer program in the LP format of CPLEX, which GLPK, CBC, HiGHS, SCIP and others read. Lines are
// short: some readers end them at 255 characters, or at 510.

#include "crosscheck/program_text.hpp"

#include <mdm/number/integer.hpp>

namespace mdm {
namespace {

/// `+ 3 q1`.
std::string lp_term(const Integer &coefficient, const std::string &variable) {
  const std::string sign = coefficient < 0 ? " - " : " + ";
  return sign + to_string(Integer(abs(coefficient))) + " " + variable;
}

/// Terms behind what stands before them, a new line where it would be long.
std::string lp_sum(std::string before, const std::vector<std::string> &terms) {
  constexpr std::size_t columns = 100;
  std::string text;
  for (const std::string &term : terms) {
    if (before.size() + term.size() > columns) {
      text += before + "\n";
      before = " ";
    }
    before += term;
  }
  return text + before;
}

} // namespace

std::string lp_text(const IntegerProgram &program) {
  const std::vector<ProgramVariable> &variables = program.variables;
  std::vector<std::string> counts;
  for (std::size_t j = 0; j < program.counts; ++j)
    counts.push_back(" + " + variables[j].name);
  std::string text =
      comment_lines(program, "\\") + "Minimize\n" + lp_sum(" particles:", counts) + "\nSubject To\n";
  for (const ProgramRow &row : program.rows) {
    std::vector<std::string> terms;
    for (const auto &[variable, coefficient] : row.terms)
      terms.push_back(lp_term(coefficient, variables[variable].name));
    text += lp_sum(" " + row.name + ":", terms) + " >= " + to_string(row.constant) + "\n";
  }
  text += "Bounds\n";
  for (const ProgramVariable &v : variables)
    text += " " + v.name + " >= " + to_string(v.least) + "\n";
  text += "General\n";
  for (std::size_t j = 0; j < program.counts; ++j)
    text += " " + variables[j].name + "\n";
  return text + "End\n";
}

} // namespace mdm
