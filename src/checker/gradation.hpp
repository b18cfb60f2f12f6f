#pragma once

#include <gmpxx.h>

#include <string>
#include <string_view>
#include <vector>

namespace mdm::checker {

using Rationals = std::vector<mpq_class>;

/// A row of a band's file: from `least` to `most` percent pass the opening.
struct Limit {
  mpq_class opening, least, most;
};

/// Openings x_1 < ... < x_n, each to the power root, masses m_1..m_n >= 0 with m_n = 0 and not all 0, factors
/// c_1..c_n > 0, and tolerances in percent >= 0 (none at all where the file has none).
struct Gradation {
  Rationals openings, masses, factors, tolerances;
  unsigned long root = 1; ///< d of section 4
  std::vector<Limit>
      limits; ///< of a band's file, whose openings, to the power 1, and masses are its middle's
  // The file's own way to say it.
  std::string sizes = "size_mm", values = "mass"; ///< the names of its columns, or what JSON has for them
  bool has_factors = false, implied_pan = false;
  /// Of several materials, that of each row: rows are sorted by material, and openings ascend within each.
  std::vector<std::string> materials;
  /// Whether row j begins a class: the last row of a material does not.
  bool begins_class(std::size_t j) const { return materials.empty() || materials[j] == materials[j + 1]; }

  /// mm, um or m: that of the openings.
  std::string unit() const;
};

/// Reads a gradation file, CSV or JSON (section 4).
Gradation read_gradation(std::string_view text);

/// The same, or one of several materials (section 14).
Gradation read_gradation_or_materials(std::string_view text);

/// Reads one by number (section 13), whose masses are the shares by number.
Gradation read_number_gradation(std::string_view text);

/// Whether the second column has shares by number.
bool is_number_column(std::string_view name);

/// The fields of a line of CSV; none at all if a quote is not closed or something follows it.
std::vector<std::string> csv_fields(std::string_view line, char delimiter);

} // namespace mdm::checker
