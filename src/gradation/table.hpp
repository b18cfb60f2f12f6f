#pragma once
/// \file
/// The rows of a gradation as a laboratory writes them.

#include "text/source.hpp"

#include <mdm/gradation/gradation.hpp>

#include <array>

namespace mdm {

/// The meaning of a column's values: mass on the sieve, or a part of the whole that passes it or does not.
enum class MassForm { retained, passing, cumulative_retained };

struct MassColumn {
  std::string_view name;  ///< in the header
  std::string_view words; ///< in messages
  MassForm form;
  unsigned full; ///< what the whole is written as; 0 where nothing says
};

inline constexpr std::array<MassColumn, 7> mass_columns = {{
    {"mass", "mass", MassForm::retained, 0},
    {"retained_g", "mass retained", MassForm::retained, 0},
    {"retained_percent", "percent retained", MassForm::retained, 100},
    {"retained_fraction", "fraction retained", MassForm::retained, 1},
    {"cumulative_retained_percent", "cumulative percent retained", MassForm::cumulative_retained, 100},
    {"passing_percent", "percent passing", MassForm::passing, 100},
    {"passing_fraction", "fraction passing", MassForm::passing, 1},
}};

/// Columns of a gradation by number, of which `mass` means the number of the particles.
inline constexpr std::array<MassColumn, 2> number_columns = {{
    {"number_percent", "percent by number", MassForm::retained, 100},
    {"cumulative_number_percent", "cumulative percent by number", MassForm::passing, 100},
}};

/// Columns of one entry a row, in the order of the file; all from the factors on may be empty.
struct Table {
  const MassColumn *column = nullptr;
  std::string id;
  SizeUnit unit = SizeUnit::mm;
  std::string file_unit; ///< as in Gradation::Data
  unsigned root = 1;
  std::size_t header_line = 1;
  std::vector<Rational> sizes; ///< to the power `root`
  std::vector<Rational> values;
  std::vector<Rational> factors;
  std::vector<Rational> tolerances;
  std::vector<Rational> roundings;      ///< half a unit of the last digit of each value
  std::vector<Rational> mass_roundings; ///< half a unit of the last digit of each share retained
  std::vector<std::string> materials;   ///< of a gradation of several
  std::vector<std::size_t> lines;       ///< where each row stands
  std::vector<std::string> notes;
  std::string format;               ///< of the file, as reports name it
  std::string sizes_from;           ///< where the sizes stand, in which unit
  std::string masses_from;          ///< the same of the values, with what they are
  std::vector<std::string> samples; ///< of a file with several
  bool has_settled_digits = false;  ///< --round was applied where the values were read
  bool is_canonical = true;         ///< the proof checker reads the same from the file
};

/// The column of that name; null if there is none.
const MassColumn *find_mass_column(std::string_view name);

/// The gradation that a table describes: sorted, with the mass of each class, and with the implied pan.
/// The rules are those of proofs/certificate-format.md, section 4. Cost: n log n comparisons.
/// \throws InputError with the line of the row where a rule does not hold
Gradation to_gradation(Table table, const Source &source);

} // namespace mdm
