#pragma once
/// \file
/// The columns of a CSV file of particles.

#include "gradation/csv_rows.hpp"
#include "particles/particle_format.hpp"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// The places of the columns. Sizes are in one column, or are known to lie between two.
/// \invariant size, or lo and hi
struct ParticleColumns {
  SizeKind kind = SizeKind::mm;
  bool has_unit = false;  ///< the header names it
  bool is_of_pfc = false; ///< its columns are those of PFC's balls, in m unless it is said otherwise
  SizeMeaning meaning = SizeMeaning::diameter;
  std::optional<std::size_t> size, lo, hi;
  unsigned power = 1; ///< of the sizes in the column size, which is of fractions where it is above 1
  std::optional<std::size_t> lower;    ///< the opening below sizes between lo and hi: they are larger
  std::optional<std::size_t> upper;    ///< the opening that they are not above
  std::optional<std::size_t> quantity; ///< open: a particle a row
  std::optional<std::size_t> id, type;
  std::optional<std::size_t> material;
  /// x, y and z, in the unit of sizes; open where one is missing or has another unit.
  std::optional<std::array<std::size_t, 3>> place;

  std::vector<std::string> passed_over; ///< names that are not known, of a file that has others besides

  /// The unit of sizes; mm for phi and sieves, which are turned into it.
  SizeUnit unit() const;
};

/// The columns of a header: a size (`size_mm`, `diameter_um`, `radius_m`, `size_phi`, `sieve`, or without a
/// unit `size`, `diameter`, `d`, `radius`, `r`) , the power of one
/// (`size_mm^3`), or its bounds (`size_lo_mm`, `size_hi_mm`), and beside it
/// `quantity` or `count`, `material`, places (`x`, `y`, `z`, also with a unit), `id`,
/// `type`, and beside bounds those of their class, `lower_mm` and `upper_mm`, and what is not read, `class`
/// and `mass`. Other columns are passed over where ParaView wrote the file (`Points:0`, `Points:1`,
/// `Points:2` are its places), or the column of sizes is named.
/// \param size_column  the name of the column of sizes; open: as above
/// \throws InputError naming the column that is unknown, missing, or there twice
ParticleColumns particle_columns(const std::vector<std::string> &names,
                                 const std::optional<std::string> &size_column = std::nullopt);

/// True of a column that ParaView writes for places.
bool is_of_paraview(std::string_view name);

/// What separates the fields of a header: `;`, else `,`, else a tab where there is one.
char csv_delimiter(std::string_view header);

/// True if a header has a column of sizes of particles, known or mistaken; of a gradation it may be.
bool has_particle_column(const std::vector<std::string> &names);

} // namespace mdm
