#pragma once
/// \file
/// Arnold's Figures 1 to 5, from exact numbers.

#include "papers/survey.hpp"
#include "plot/figure.hpp"

namespace mdm {

/// Grading curves of the subset, and the areas of which I_C is the ratio on one of them.
Figure paper_figure1(const std::vector<SurveyRow> &rows);
/// Total error over iterations, SI and FS.
Figure paper_figure2(const std::vector<Convergence> &runs);
/// N over phi_1; the colour is log10 zeta_1. Beside it the N of SI as the paper ran it.
Figure paper_figure3(const std::vector<SurveyRow> &rows);
/// N over I_C; as Figure 3.
Figure paper_figure4(const std::vector<SurveyRow> &rows);
/// N over I_GS, a panel a group name.
Figure paper_figure5(const std::vector<SurveyRow> &rows);

} // namespace mdm
