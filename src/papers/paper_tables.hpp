#pragma once
/// \file
/// The numbers of Arnold's Table 1 and Figures 1 to 5 as CSV.

#include "papers/survey.hpp"

namespace mdm {

// Headers name the units; shares, ratios and indices have none, N is a number of particles. Numbers have 15
// significant digits, irrational ones 10, all certain. A cell is empty where there is no value.

/// Every n-th gradation is in Figures 1 and 2: the paper's "10 percent".
inline constexpr std::size_t subset_step = 10;

/// The member of the subset that Figure 1 shows in detail: its I_C is closest to 1.09, as in the paper.
/// Nothing if no member has an I_C.
std::optional<std::size_t> figure1_example(const std::vector<SurveyRow> &rows);

/// parameter,unit,least,greatest,least_id,greatest_id; extremes decided exactly, the first that has them.
std::string table1_csv(const std::vector<SurveyRow> &rows);
/// id,i_c,example,size_mm,passing_percent: the curves of the subset.
std::string figure1_csv(const std::vector<SurveyRow> &rows);
/// id,algorithm,iteration,particles,total_error_percent of the subset.
std::string figure2_csv(const std::vector<Convergence> &runs);
/// id,phi_1,zeta_1,log10_zeta_1, and the counts: n_exact,n_spanned_integer,n_spanned_integer_printed,
/// n_fixed_size,n_rounded (SurveyCounts).
std::string figure3_csv(const std::vector<SurveyRow> &rows);
/// id,i_c,zeta_1,log10_zeta_1, and the counts.
std::string figure4_csv(const std::vector<SurveyRow> &rows);
/// id,i_gs,group_symbol,group_name, and the counts.
std::string figure5_csv(const std::vector<SurveyRow> &rows);

} // namespace mdm
