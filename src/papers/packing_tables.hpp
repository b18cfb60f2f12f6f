#pragma once
/// \file
/// The numbers of the figures with packings as CSV.

#include "packing/apollonian.hpp"
#include "papers/packing_study.hpp"

namespace mdm {

// Columns _lo and _hi are the ends of proved enclosures, other numbers have up to 10 significant digits, all
// certain. A cell is empty where there is no value.

/// Figure 2: p,q,radius,x,y of each circle with a curvature p + q sqrt(3) up to `most`; centres from that of
/// the outer circle.
std::string gasket_table(const ApollonianGasket &gasket, const Rational &most);

/// Figure 9: a,b,classing,span,discs,deposits,fraction_lo,fraction_hi,scatter_lo,scatter_hi,... of each
/// point, the mean and the range of its deposits; `note` says why a point is left out.
std::string figure9_table(const PackingStudy &study);

/// Each deposit of Figure 9: a,b,classing,span,seed,width_factor,discs,fraction_lo,fraction_hi,...
std::string deposits_table(const std::vector<PackingPoint> &points);

/// A packing with the span it is drawn for.
struct Snapshot {
  Rational span;
  Packing packing;
};

/// Figures 10 and 11: span,x,y,radius,contacts of each disc, in d_min.
std::string discs_table(const std::vector<Snapshot> &snapshots);
/// Figure 10: corners,discs of each cell; discs are counted from 0, in the order of discs_table.
std::string cells_table(const Packing &packing);

} // namespace mdm
