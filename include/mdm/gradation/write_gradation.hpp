#pragma once
/// \file
/// Canonical gradation files.

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// The canonical CSV of g: `size_<unit>,mass`, `tolerance_percent` and `factor` where g has them, sizes ascending.
std::string gradation_csv(const Gradation &g);

/// The canonical JSON of g: one line {"id", "unit", "sizes", "masses"}, `factors` and `tolerances_percent` where g has them.
std::string gradation_json(const Gradation &g);

} // namespace mdm
