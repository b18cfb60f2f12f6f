#pragma once
/// \file
/// The question about a gradation as an integer program, for other solvers.

#include <mdm/match/question.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace mdm {

struct ProgramVariable {
  std::string name;
  bool is_integer = true;
  Integer least = 0;           ///< closed
  std::optional<Integer> most; ///< closed; integers of a program of integers have one
};

/// sum coefficient * variable >= constant, or > constant.
struct ProgramRow {
  std::string name;
  std::vector<std::pair<std::size_t, Integer>> terms; ///< variable, and coefficient != 0
  Integer constant = 0;
  bool is_strict = false;
  std::optional<std::size_t> where = std::nullopt; ///< holds where this variable is at least 1, else always
};

/// What a language has.
enum class ProgramForm {
  strict,  ///< real numbers and strict inequalities
  stepped, ///< real numbers, no strict inequalities: the smallest step that is proved to be enough instead
  integers ///< integers alone
};

/// Minimise the sum of the first `counts` variables, q_j for the particles of class j from the finest on.
/// An optimum is a smallest match, and its counts are an optimum (Theorem 26).
struct IntegerProgram {
  std::string id;
  std::vector<ProgramVariable> variables;
  std::size_t counts = 0;
  std::vector<ProgramRow> rows;
  std::vector<std::string> comments; ///< a line each: what is asked, and what variables and rows are
};

/// The program of a question. Cost: rows and classes; of integers the square of classes.
/// \param form_name  of the form, for messages
/// \throws InputError where a question has no such program: a law that is irrational at an opening, a volume
/// of solids (of which pi is a factor), a tolerance in integers alone, or, with steps, a band outside of
/// which the gradation itself is
IntegerProgram integer_program(const Gradation &g, const Question &question, ProgramForm form,
                               const std::string &form_name);

} // namespace mdm
