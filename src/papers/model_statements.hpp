#pragma once
/// \file
/// What Voivret, Delenne and Radjai say of the beta model, of the sets made from it and of the shapes that
/// are accessible, beside exact numbers.

#include "papers/size_models.hpp"
#include "papers/statement.hpp"

namespace mdm {

/// The numbers of Figures 4 to 8.
struct ModelStudy {
  std::vector<CoefficientRow> coefficients;
  std::vector<SetRow> classes, class_sizes, totals;
  std::vector<ShapeRow> maps;
};

/// All statements. Where the paper has a word and no number, `found` says what was asked.
std::vector<Statement> model_statements(const ModelStudy &study);

/// The statements on the shapes' words alone (section 2.1), each of the density h' and of the grading curve
/// h: by the signs of differences of h at twelve sizes, decided.
std::vector<Statement> shape_statements();

} // namespace mdm
