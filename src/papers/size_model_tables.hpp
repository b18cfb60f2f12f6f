#pragma once
/// \file
/// The numbers of the figures of Voivret, Delenne and Radjai as CSV.

#include "papers/size_models.hpp"

namespace mdm {

// Counts are exact, other numbers have up to 10 significant digits, all certain. A cell is empty where there
// is no value.

/// size_mm,number_density,volume_density,partition,grading: f and V per mm, F and h
std::string table_csv(const std::vector<DistributionRow> &rows);
/// a,b,reduced_size,passing
std::string table_csv(const std::vector<PassingRow> &rows);
/// a,b,span,C_u,C_c
std::string table_csv(const std::vector<CoefficientRow> &rows);
/// a,b,classing,classes,min_per_class,at_least,n_estimated,n,C_r: N_c, N_pc, N_min, sum N' and N.
std::string table_csv(const std::vector<SetRow> &rows);
/// classing,span,a,b,particles,C_u
std::string table_csv(const std::vector<ShapeRow> &rows);

} // namespace mdm
