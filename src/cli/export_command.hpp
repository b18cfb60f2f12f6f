#pragma once
/// \file
/// What the user asks mdm export for.

#include "cli/output_flags.hpp"
#include "cli/reading_flags.hpp"
#include "cli/solve_flags.hpp"
#include "particles/cost.hpp"
#include "particles/export_format.hpp"

#include <vector>

namespace mdm::cli {

/// A file that lies in the folder of the one that was asked for.
struct FileBeside {
  std::string path;
  void (*write)(const Placement &, const Sink &);
};

struct ExportCommand {
  OptionText file; ///< open: the band alone
  SolveFlags flags;
  std::vector<CLI::Option *> solving; ///< options that only a gradation has a use for
  OptionText unit, size_unit, density, mass_error, box, seed, young, poisson, model, steps, start, sides,
      pressure, tolerance, friction, friction_while_filling, types, material;
  ReadingFlags reading;
  std::string to;
  OutputFlags output;
  bool spread = false;
  bool periodic = false; ///< on all sides
  bool yes_huge = false;
  bool yes_units = false;
};

/// \throws InputError if --to is none
const ExportFormat &export_format(const ExportCommand &c);

/// Those that the format has, a model's aside. \throws InputError if it has some and -o is no file
std::vector<FileBeside> files_beside(const ExportCommand &c, const ExportFormat &format);

/// A positive number that engines compute with as a double.
Rational physical(const std::string &name, const std::string &text);

std::uint64_t seed_of(const ExportCommand &c);
Elasticity elasticity(const ExportCommand &c);

/// Refuses options that do not go together, or that the format has no use for.
void check_export(const ExportCommand &c, const ExportFormat &format);
/// Refuses options that only particles of a gradation have a use for.
void check_export_of_packing(const ExportCommand &c);

} // namespace mdm::cli
