#pragma once
/// \file
/// What a paper says, beside what exact numbers show of it.

#include <string>
#include <vector>

namespace mdm {

/// What the numbers say of a statement.
enum class Holds {
  yes,
  partly,
  no,
  open, ///< the study has no numbers for it, or the statement has none that can be asked
};

/// `holds`, `holds in part`, `does not` or `cannot be decided`.
const char *name(Holds holds);

/// How many of all cases are as it says; open without any.
Holds holds_in(std::size_t some, std::size_t all);

/// A statement of a paper.
struct Statement {
  std::string statement;
  std::string where; ///< in the paper
  std::string found; ///< by exact numbers; where the paper has none, with what was asked
  Holds holds;
  std::string command; ///< that shows it; capitals stand for files and folders
};

/// statement,where,found,holds,command
std::string statements_table(const std::vector<Statement> &statements);

} // namespace mdm
