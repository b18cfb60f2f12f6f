#pragma once
/// \file
/// Canonical files of gradations and envelopes.

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>

namespace mdm {

// Numbers are decimals in plain notation, or with an exponent where that takes more than 1000 digits. All
// throw InputError where a number has no such decimal (1/3), and end with a line feed.

/// The canonical CSV of g: `size_<unit>,mass`, `tolerance_percent`, `factor` and `material` where g has them,
/// sizes ascending, within each material.
std::string gradation_csv(const Gradation &g);

/// The canonical JSON of g: one line {"id", "unit", "sizes", "masses"}, `factors` and `tolerances_percent`
/// where g has them.
/// \pre g has one material
std::string gradation_json(const Gradation &g);

/// The canonical CSV of an envelope: `size_<unit>,passing_min_percent,passing_max_percent`, sizes ascending.
std::string envelope_csv(const Envelope &envelope);

} // namespace mdm
