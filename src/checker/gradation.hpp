#pragma once

#include <gmpxx.h>

#include <string_view>
#include <vector>

namespace mdm_check {

using Rationals = std::vector<mpq_class>;

/// Openings x_1 < ... < x_n, masses m_1..m_n >= 0 with m_n = 0 and not all 0, factors c_1..c_n > 0, and
/// tolerances in percent >= 0 (none at all where the file has none).
struct Gradation {
  Rationals openings, masses, factors, tolerances;
};

/// Reads a gradation file, CSV or JSON (section 4).
Gradation read_gradation(std::string_view text);

} // namespace mdm_check
