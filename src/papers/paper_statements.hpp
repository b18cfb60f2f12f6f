#pragma once
/// \file
/// What Arnold says of the suite, the algorithms and the numbers of particles, beside exact numbers.

#include "papers/statement.hpp"
#include "papers/survey.hpp"

namespace mdm {

/// All statements, with numbers of this suite. Relations are lines of least squares through logarithms,
/// enclosed; where the paper has a word and no number, `found` says what was asked.
/// \param runs  the convergence of the subset of Figure 2
std::vector<Statement> paper_statements(const std::vector<SurveyRow> &rows,
                                        const std::vector<Convergence> &runs);

} // namespace mdm
