#pragma once
/// \file
/// Integer programs in the languages of solvers.

#include "crosscheck/integer_program.hpp"

#include <string_view>

namespace mdm {

/// A language of integer programs.
enum class ProgramLanguage {
  lp,   ///< CPLEX LP
  mps,  ///< free MPS
  smt2, ///< SMT-LIB 2.6 with `minimize`, as z3 and OptiMathSAT have it
  mzn,  ///< MiniZinc
  opb,  ///< pseudo-Boolean: counts in binary digits
  json  ///< schema mdm-problem-1
};

/// `lp`, `mps` and so on, in their order.
std::vector<std::string> program_language_names();
std::optional<ProgramLanguage> program_language_named(std::string_view name);
/// What the language has.
ProgramForm form_of(ProgramLanguage language);

/// The program as a file. \pre it is of form_of(language)
/// \throws InputError where the language has no numbers as long as the program's
std::string program_text(const IntegerProgram &program, ProgramLanguage language);

std::string lp_text(const IntegerProgram &program);
std::string mps_text(const IntegerProgram &program);
std::string smt2_text(const IntegerProgram &program);
std::string minizinc_text(const IntegerProgram &program);
std::string pseudo_boolean_text(const IntegerProgram &program);
std::string program_json(const IntegerProgram &program);

/// The comments, each line behind `mark`.
std::string comment_lines(const IntegerProgram &program, std::string_view mark);

/// Where the binary digits of a count are in opb: x`first` and those behind it, the lowest first.
struct BinaryDigits {
  std::size_t first, count;
};

/// Those of each variable, whose value is its least and what its digits add. \pre of integers
std::vector<BinaryDigits> binary_digits(const IntegerProgram &program);

} // namespace mdm
