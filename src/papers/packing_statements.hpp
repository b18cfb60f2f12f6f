#pragma once
/// \file
/// What Voivret, Delenne and Radjai say of their packings, beside what deposits show.

#include "papers/packing_study.hpp"
#include "papers/statement.hpp"

namespace mdm {

/// All statements, each with numbers of the study. Where the paper has no number, `found` says what was
/// asked.
std::vector<Statement> packing_statements(const PackingStudy &study);

} // namespace mdm
