#pragma once
/// \file
/// Names of soils after ISO 14688-2:2004 by the shares of their fractions, decided exactly.

#include "soil/available.hpp"
#include "soil/grading_curve.hpp"

#include <string>

namespace mdm {

/// A soil's name, as a symbol (`saGr`) and in words (`sandy gravel`).
struct Iso14688Name {
  std::string symbol, words;
};

/// The name of what passes 63 mm in the diagram of Annex B (informative) of ISO 14688-2:2004, with gravel
/// down to 2 mm, sand down to 0.063 mm, and silt down to 0.002 mm:
///
/// - From 40 % of fines on they are the noun: silt, clayey silt, silty clay and clay up to and from 10, 20
/// and
///   40 % of clay in them. From 15 % on they are silty, or from 20 % of clay in them on clayey, beside a noun
///   of 40 % or more, or beside "soil" (S) where no fraction has as much. Below they are not named.
/// - Sand and gravel are adjectives from 20 % on; the greater comes last, of equal ones gravel.
/// - What is at a limit is above it.
///
/// Not available where the curve does not tell a share, nothing passes 63 mm, or the diagram has no name:
/// clayey silt and silty clay with 20 % of both sand and gravel.
Available<Iso14688Name> iso_14688_name(const GradingCurve &curve);

} // namespace mdm
