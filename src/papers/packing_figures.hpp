#pragma once
/// \file
/// The figures with packings of Voivret, Delenne and Radjai.

#include "papers/packing_tables.hpp"
#include "plot/figure.hpp"

namespace mdm {

/// Figure 2: circles between three equal ones, down to the radius 1 / most in theirs.
Figure gasket_figure(const Packing &gasket, const Rational &most);
/// Figure 9: packing fraction over the span, the range of the deposits as bars.
Figure fraction_figure(const PackingStudy &study);
/// Figure 10: a packing, and its regions by the corners of the cells.
Figure regions_figure(const Snapshot &snapshot);
/// Figure 11: packings side by side.
Figure snapshots_figure(const std::vector<Snapshot> &snapshots);

} // namespace mdm
