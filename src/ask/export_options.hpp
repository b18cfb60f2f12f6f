#pragma once
/// \file
/// Particles for DEM codes: what is asked.

#include "ask/outcome.hpp"
#include "ask/particle_options.hpp"
#include "ask/reading_options.hpp"
#include "ask/solve_options.hpp"
#include "particles/cost.hpp"
#include "particles/export_format.hpp"
#include "particles/kept_places.hpp"

#include <vector>

namespace mdm {

/// A file that lies in the folder of the one that was asked for.
struct FileBeside {
  std::string path;
  void (*write)(const Placement &, const Sink &);
};

/// What is asked of the particles, as texts.
struct ExportTexts {
  OptionText file; ///< open: the band alone
  SolveTexts solve;
  BudgetTexts budget;
  std::vector<std::string> solving; ///< the options that are given that only a gradation has a use for
  OptionText unit, density, mass_error, box, seed, young, poisson, model, steps, start, sides, pressure,
      tolerance, dimension, axial_strain, constant, friction, friction_while_filling, rolling_friction,
      surface_energy, cohesion_energy_density, types, material, gradation;
  ReadingTexts reading;
  std::string to, out = "-";
  ParticleTexts particles; ///< of FILE, where it is a file of them
  bool spread = false;
  bool periodic = false; ///< on all sides
  bool unjammed = false; ///< a model's result may be
  bool yes_huge = false, yes_units = false;

  bool is_triaxial() const { return model == "triaxial"; }
  /// True if a model of discs is asked for.
  bool has_discs() const { return dimension == "2"; }
  /// True if the model's box has six faces that move: walls, or it is repeated on all sides.
  bool moves_faces() const { return periodic || is_triaxial(); }
  bool has_six_walls() const { return is_triaxial() && to == "liggghts"; }
  /// True if the model's box is repeated on all sides.
  bool has_cell() const { return moves_faces() && !has_six_walls(); }

  static const std::vector<OptionRow<ExportTexts>> options, start_options, model_options, size_options;
  /// Those of `particles` that export has.
  static const std::vector<OptionRow<ParticleTexts>> particle_options;
};

/// The particles to export, and how the search for them ended.
struct ExportedParticles {
  std::optional<ParticleSet> set; ///< nothing: there is no match
  Outcome outcome = Outcome::done;
  SizeUnit unit = SizeUnit::mm;          ///< of lengths in options
  std::string question;                  ///< of an answer, in words
  bool has_gradation = true;             ///< FILE is one, by which the particles can be judged
  std::optional<KeptPlaces> places = {}; ///< that a file of particles has
  OptionText size_factor = {};           ///< that a budget chose
};

/// \throws InputError if --to is none
const ExportFormat &export_format(const ExportTexts &c);

/// Those that the format has, a model's aside. \throws InputError if it has some and -o is no file
std::vector<FileBeside> files_beside(const ExportTexts &c, const ExportFormat &format);

/// A positive number that engines compute with as a double.
Rational physical(const std::string &name, const std::string &text);
/// One in Pa, or with its unit: 100kPa, 5 MPa, 70GPa.
Rational pressure(const std::string &name, const std::string &text);

ParticleSetOptions set_options(const ExportTexts &c, bool has_floats);
/// The options of solving as far as a model does not take them for itself.
SolveTexts texts_of_solving(const ExportTexts &c);
/// Refuses the options of solving, of which there is no more to ask. \param what  the particles
void refuse_options_of_solving(const ExportTexts &c, const char *what);
/// The options with which mdm verify takes the gradation as it was asked for; nothing where there is a band
/// alone.
std::optional<std::string> verify_options(const ExportTexts &c);

std::uint64_t export_seed(const ExportTexts &c);
Elasticity elasticity(const ExportTexts &c);

/// Refuses options that do not go together, or that the format has no use for.
void check_export(const ExportTexts &c, const ExportFormat &format);
/// Refuses options that only particles of a gradation have a use for.
void check_export_of_packing(const ExportTexts &c);

} // namespace mdm
