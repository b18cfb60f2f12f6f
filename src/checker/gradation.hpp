#pragma once

#include "text.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mdm_check {

/// Openings x_1 < ... < x_n, masses m_1..m_n >= 0 with m_n = 0 and not all 0, factors c_1..c_n > 0.
struct Gradation {
  std::vector<mpq_class> openings, masses, factors;
};

/// No gradation has more openings; it bounds the memory.
constexpr std::size_t most_rows = std::size_t{1} << 20U;

/// Reads a gradation file, CSV or JSON (section 4).
Gradation read_gradation(std::string_view text);

Gradation read_csv(std::string_view text);
Gradation read_json(std::string_view text);

/// Demands what both formats demand: ascending openings, masses not negative, the last 0 and some positive.
/// The lines are those of the openings.
void demand_complete(const Gradation &gradation, const std::vector<std::size_t> &lines);

/// The opening in mm of a sieve's name (section 5), where a length is written with the decimal `point`.
mpq_class sieve_opening(std::string_view name, char point, std::size_t line);

/// 2^-phi (mm): exact for an integer, else the nearest decimal of 15 significant digits.
mpq_class phi_opening(const mpq_class &phi, std::size_t line);

} // namespace mdm_check
