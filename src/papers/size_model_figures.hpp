#pragma once
/// \file
/// The figures of Voivret, Delenne and Radjai, from exact numbers.

#include "papers/size_models.hpp"
#include "plot/figure.hpp"

namespace mdm {

/// Figure 1: densities and cumulative functions by number and by volume.
Figure distribution_figure(const std::vector<DistributionRow> &rows);
/// Figure 3: grading curves of the model.
Figure passing_figure(const std::vector<PassingRow> &rows);
/// Figure 4: C_u and C_c over the span.
Figure coefficient_figure(const std::vector<CoefficientRow> &rows);

/// The source of a set.
enum class Criterion { classes, min_per_class, at_least };
/// Figures 5 to 7: C_r and N over N_c, N_pc or N_min.
Figure set_figure(const std::vector<SetRow> &rows, Criterion varied);

/// Figure 8: the accessible shapes, their C_u, and it over the span.
Figure accessible_figure(const std::vector<ShapeRow> &maps, const std::vector<ShapeRow> &spans);

} // namespace mdm
