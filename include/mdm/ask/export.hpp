#pragma once
/// \file
/// The particles of a match as a file for a DEM code.

#include <mdm/match/match.hpp>

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The way particles are written.
struct ExportOptions {
  SizeUnit unit = SizeUnit::m; ///< of all lengths
  Rational density = 2650;     ///< kg/m^3, > 0; the factor of a class multiplies it
  std::uint64_t seed = 1;      ///< of the places
};

/// The names of the formats, for example `liggghts`, `lammps` and `yade`: those of `mdm export --to` that are
/// one file.
std::vector<std::string> export_formats();

/// Writes the particles, in exact counts (but for `mercurydpm`, which draws at random), each as close to its
/// class's mass as 1e-9 of it, or 2e-7 where the format has floats. Where the format has places, the
/// particles lie in layers, a slab a class, on a square that makes them about as high as wide; no two
/// overlap. Cost: some 100 ns a particle. Whether `out` took all is for its owner to see.
/// \throws InputError where there is no such format, the match has no sample, a class has no number close
/// enough to its size, or there are more particles than a format counts
void export_particles(const Match &m, std::string_view format, std::ostream &out,
                      const ExportOptions &options = {});

} // namespace mdm
