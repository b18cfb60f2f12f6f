#pragma once
/// \file
/// What solvers of integer programs write: the counts q1, q2 and so on.

#include "crosscheck/integer_program.hpp"
#include "crosscheck/other_answer.hpp"

namespace mdm {

/// An answer, and what was assumed of it.
struct Solution {
  OtherAnswer answer;
  std::vector<std::string> notes;
};

/// The counts of a solution of the program of a question, as an answer. Read are files in which a name stands
/// before its value: those of GLPK (`-o`), CBC, HiGHS, SCIP, lp_solve, Gurobi, of z3 (get-value and
/// get-model) and MiniZinc, of which the last solution counts; and the `v` lines of pseudo-Boolean solvers,
/// for the program in opb. A count that such a file leaves out is 0, as solvers leave zeros out, which a note
/// says. Where a line says that there is no solution the answer is `infeasible`, where it says that none was
/// found and there is none `gave-up`. What cannot be read is garbage: nothing is thrown.
/// \param program  with counts of any form; of integers for `v` lines
Solution read_solution(std::string_view text, const IntegerProgram &program);

/// True for a text of a pseudo-Boolean solver that has a solution, for which the program of integers is
/// needed.
bool has_binary_values(std::string_view text);

} // namespace mdm
