#pragma once
/// \file
/// Accessible shapes as text, JSON, CSV and map.

#include "papers/accessible_shapes.hpp"
#include "plot/figure.hpp"

namespace mdm {

/// The number of undecided shapes and the reasons, a line a reason; empty if all are decided.
std::vector<std::string> undecided(const std::vector<AccessibleRow> &rows);

/// A map of letters for each span, and what is behind its question marks, for people.
std::string accessible_text(const AccessibleQuestion &question, const std::vector<AccessibleRow> &rows);

/// One line of JSON, schema `mdm-accessible-1`, without a newline at its end.
std::string accessible_json(const AccessibleQuestion &question, const std::vector<AccessibleRow> &rows);

/// span,a,b,paper_particles,paper_accessible,match_particles,match_accessible,Cu_lo,Cu_hi,Cc_lo,Cc_hi; true,
/// false, or empty where it is not known.
std::string accessible_csv(const std::vector<AccessibleRow> &rows);

/// For each span the shapes that are accessible by Eq. 6-9 and by the least match, coloured by their number
/// of particles; with several spans also the range of C_u that is accessible over the span.
Figure accessible_map(const AccessibleQuestion &question, const std::vector<AccessibleRow> &rows);

} // namespace mdm
