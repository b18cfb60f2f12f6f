#pragma once
/// \file
/// What solvers of integer programs write: the counts q1, q2 and so on.

#include "crosscheck/integer_program.hpp"
#include "crosscheck/other_answer.hpp"

namespace mdm {

/// The counts of a solution of the program of a question, as an answer. Read are files in which a name stands
/// before its value: those of GLPK (`-o`), CBC, HiGHS, SCIP, lp_solve, Gurobi, of z3 (get-value and
/// get-model) and MiniZinc, of which the last solution counts; and the `v` lines of pseudo-Boolean solvers,
/// for the program in opb. A count that a file leaves out is 0, as solvers leave zeros out. A text that says
/// that there is no solution, and names none, is the answer `infeasible`. What cannot be read is garbage:
/// nothing is thrown.
/// \param program  with counts of any form; of integers for `v` lines
OtherAnswer solution_answer(std::string_view text, const IntegerProgram &program);

/// True for a text with `v` lines, for which the program of integers is needed.
bool has_binary_values(std::string_view text);

} // namespace mdm
