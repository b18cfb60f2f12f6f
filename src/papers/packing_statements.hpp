#pragma once
/// \file
/// What Voivret, Delenne and Radjai say of their packings, beside what deposits show.

#include "papers/packing_study.hpp"

namespace mdm {

/// A statement of the paper.
struct Statement {
  std::string statement;
  std::string where; ///< in the paper
  std::string found; ///< in the deposits of this study
  std::string holds; ///< yes, no, partly, or open where the study has no deposit for it
};

/// All statements, each with numbers of the study. Where the paper has no number, `found` says what was
/// asked.
std::vector<Statement> packing_statements(const PackingStudy &study);

} // namespace mdm
