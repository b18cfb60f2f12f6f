#include "ask/export_model.hpp"

#include "ask/option_values.hpp"
#include "particles/material_table.hpp"
#include "particles/particle_writer.hpp"
#include "text/file_names.hpp"
#include "text/filesystem_path.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace mdm {

struct ModelEngine {
  const char *name;
  std::string (*script)(const SettleModel &);
  void (*write_particles)(const Placement &, const Sink &);
  void (*write_classes)(const Placement &, const Sink &); ///< with a type a class
  void (*write_discs)(const Placement &, const Sink &);   ///< null: there is no model of them
  const char *particles_ending;
  bool reads_planes; ///< as meshes
  bool resists_rolling;
  const CohesionLaw *cohesion; ///< null: it has none
};

namespace {

constexpr std::array<ModelEngine, 3> engines = {
    {{"liggghts", liggghts_model, write_lammps_data, write_lammps_data_of_classes, nullptr, ".data", true,
      true, &sjkr_law},
     {"lammps", lammps_model, write_lammps_data, write_lammps_data_of_classes, write_lammps_data_of_discs,
      ".data", false, true, &jkr_law},
     {"yade", yade_model, write_xyzr, write_xyzr, write_xyzr, ".xyzr", false, false, nullptr}}};

/// A coefficient of friction.
std::optional<double> friction_of(const char *name, const OptionText &text) {
  if (!text)
    return std::nullopt;
  const Rational mu = not_negative(name, *text);
  if (mu > 10)
    throw InputError(option(name) + ": " + in_quotes(*text) + " is no coefficient of friction: give 0 to 10");
  return mu.convert_to<double>();
}

double void_ratio_of(const std::string &text) {
  const Rational e = positive("void-ratio", text);
  if (e > 100)
    throw InputError(option("void-ratio") + ": " + in_quotes(text) + " is above 100, which no bed has");
  return e.convert_to<double>();
}

std::optional<DensityTarget> density_target(const ExportTexts &c) {
  if (!c.solve.void_ratio && !c.pressure)
    return std::nullopt;
  DensityTarget target;
  if (c.pressure)
    target.pressure = pressure("stress", *c.pressure).convert_to<double>();
  else
    target.void_ratio = void_ratio_of(*c.solve.void_ratio);
  if (c.tolerance) {
    const Rational tolerance = positive("target-tolerance", *c.tolerance);
    if (tolerance >= 1 || tolerance < ratio(1, 1000000))
      throw InputError(option("target-tolerance") + ": " + in_quotes(*c.tolerance) +
                       " is not from 1e-6 to below 1");
    target.tolerance = tolerance.convert_to<double>();
  }
  return target;
}

/// \throws InputError if grains have rolling friction, and the engine has no model of it here
void check_rolling(const SettleModel &model, const ModelEngine &engine) {
  if (!engine.resists_rolling && model.resists_rolling())
    throw InputError(
        option("rolling-friction") +
        ": YADE's contact of Hertz and Mindlin limits a moment by a length that is the same for grains of "
        "all sizes: use " +
        option("to") + " liggghts or lammps");
}

/// The number of the engine's law of cohesion; 0: none.
/// \throws InputError if it is that of another engine
double cohesion_of(const ExportTexts &c, const ModelEngine &engine) {
  double cohesion = 0;
  for (const auto &[law, text] :
       {std::pair<const CohesionLaw *, const OptionText &>(&jkr_law, c.surface_energy),
        {&sjkr_law, c.cohesion_energy_density}}) {
    if (!text)
      continue;
    if (engine.cohesion == nullptr)
      throw InputError(option(law->option) + ": there is no model of cohesion for YADE: use " + option("to") +
                       " liggghts or lammps");
    if (engine.cohesion != law)
      throw InputError(option(law->option) + ": it is of another law than this engine's: give " +
                       option(engine.cohesion->option));
    cohesion = physical(law->option, *text).convert_to<double>();
  }
  return cohesion;
}

/// \throws InputError if grains are too soft for their cohesion
void check_cohesion(const SettleModel &model, const ModelEngine &engine) {
  if (model.cohesion == 0)
    return;
  constexpr double most_overlap = 0.05;
  const double part = smallest_contact(model, settling(model).elasticity, *engine.cohesion).overlap /
                      (2 * model.set.smallest().radius.value);
  if (part > most_overlap)
    throw InputError(fmt::format("{}: two of the smallest grains would overlap by {:.2g} of their diameter "
                                 "where nothing presses, more than {}: give less, or a stiffer {}",
                                 option(engine.cohesion->option), part, most_overlap,
                                 option(model.materials.empty() ? "young" : "material")));
}

/// Discs have masses by the squares of their sizes.
void check_masses_of_discs(const ParticleSet &set) {
  const MassLaw &law = set.law;
  if (!law.is_power() || law.exponent() != "2")
    throw InputError(option("dimension") +
                     " 2: the masses of discs are by the squares of their sizes: give a "
                     "gradation, or its answer, and " +
                     option("law") + " power:2");
}

/// A cell that is repeated is only compressed.
void check_reachable(const SettleModel &model, const Placement &start) {
  if (model.space != Space::periodic_cell || !model.target || !model.target->void_ratio)
    return;
  const Rational most = start.void_ratio().second;
  if (*model.target->void_ratio > most.convert_to<double>())
    throw InputError(
        fmt::format("{}: {:.6g} is above {}, that of the start, and the cell is compressed from there: ask "
                    "for less",
                    option("void-ratio"), *model.target->void_ratio, approximate(most, 4)));
}

std::optional<TriaxialShear> shear_of(const ExportTexts &c) {
  if (!c.is_triaxial())
    return std::nullopt;
  TriaxialShear shear;
  if (c.axial_strain) {
    const Rational strain = positive("axial-strain", *c.axial_strain);
    if (strain > ratio(1, 2) || strain < ratio(1, 1000))
      throw InputError(option("axial-strain") + ": " + in_quotes(*c.axial_strain) +
                       " is not from 0.001 to 0.5: give the part of its height by which the cell shrinks");
    shear.axial_strain = strain.convert_to<double>();
  }
  if (c.constant && c.constant != "sigma_3" && c.constant != "p")
    throw InputError(option("constant") + ": " + in_quotes(*c.constant) + " is neither sigma_3 nor p");
  if (c.constant == "p")
    shear.constant = ConstantStress::p;
  if (c.solve.void_ratio)
    shear.void_ratio = void_ratio_of(*c.solve.void_ratio);
  return shear;
}

std::uint64_t steps_of(const std::string &text) {
  const Integer steps = natural("steps", text, 0);
  if (steps > Settling::most_steps)
    throw InputError(
        fmt::format("{0}: {1} are more than the {2} that LAMMPS and LIGGGHTS make in a run: give "
                    "fewer {0}",
                    option("steps"), in_quotes(text), Settling::most_steps));
  return static_cast<std::uint64_t>(steps);
}

} // namespace

ModelWriter::ModelWriter(const std::string &model, const std::string &to, std::string out)
    : engine_(std::find_if(engines.begin(), engines.end(),
                           [&to](const ModelEngine &engine) { return to == engine.name; })),
      plane_(model == "triaxial" ? "wall" : "lid"), out_(std::move(out)) {
  if (model != "settle" && model != "triaxial")
    throw InputError(option("model") + ": " + in_quotes(model) + " is none: there are settle and triaxial");
  if (engine_ == engines.end())
    throw InputError(option("model") + ": there is none for " + to + ": use " + option("to") +
                     " liggghts, lammps or yade");
  if (out_ == "-")
    throw InputError(option("model") + ": what it reads and writes lies beside it: say where with -o FILE");
  if (engine_->script == yade_model && filesystem_path(out_).extension() != ".py")
    throw InputError("-o: YADE runs models that end in .py: give it such a name");
  std::error_code none;
  if (const auto type = std::filesystem::status(filesystem_path(out_), none).type();
      type != std::filesystem::file_type::not_found && type != std::filesystem::file_type::regular)
    throw InputError("-o: " + printable(out_) +
                     " is no regular file, beside which a model's other files could lie: give another name");
}

std::vector<std::string> ModelWriter::other_files() const {
  const std::filesystem::path out = filesystem_path(out_);
  std::vector<std::string> files{
      path_name(std::filesystem::path(out).replace_extension(engine_->particles_ending))};
  if (engine_->reads_planes)
    files.push_back(path_name(out.parent_path() / (out.stem() += fmt::format("-{}.stl", plane_))));
  return files;
}

SettleModel ModelWriter::model(const ExportTexts &c, const ExportedParticles &found, const Placement &start,
                               const ReadMaterial &read) const {
  const auto length = [&start](std::size_t axis) {
    return std::strtod(start.text(start.box()[axis]).c_str(), nullptr);
  };
  SettleModel model{*found.set,
                    {length(0), length(1), length(2)},
                    path_name(filesystem_path(other_files().front()).filename()),
                    path_name(filesystem_path(out_).stem())};
  model.space = asked_space(c);
  if (c.has_discs()) {
    check_masses_of_discs(*found.set);
    model.box.y = disc_length(*found.set);
  }
  model.target = density_target(c);
  check_reachable(model, start);
  model.shear = shear_of(c);
  if (c.steps)
    model.steps = steps_of(*c.steps);
  const Elasticity e = elasticity(c);
  if (c.young)
    model.young = e.young;
  model.poisson = e.poisson;
  model.friction = friction_of("friction", c.friction).value_or(model.friction);
  model.friction_while_filling = friction_of("friction-while-filling", c.friction_while_filling);
  model.rolling_friction = friction_of("rolling-friction", c.rolling_friction).value_or(0);
  model.unjammed = c.unjammed;
  model.types_of_classes = c.types == "class" || c.material || c.has_six_walls();
  if (c.material)
    model.materials = read_materials(
        read(*c.material), shown_name(*c.material), *found.set,
        {settling(model).elasticity, Settling::restitution, model.friction, model.rolling_friction});
  check_rolling(model, *engine_);
  model.cohesion = cohesion_of(c, *engine_);
  check_cohesion(model, *engine_);
  model.verify_options = verify_options(c);
  model.question = found.question;
  return model;
}

void ModelWriter::write(const SettleModel &model, const Placement &start, const WriteFiles &write) const {
  const std::vector<std::string> files = other_files();
  std::vector<ModelFile> all = {{out_, [&](const Sink &sink) { sink(engine_->script(model)); }}};
  const auto write_particles = model.has_discs()        ? engine_->write_discs
                               : model.types_of_classes ? engine_->write_classes
                                                        : engine_->write_particles;
  all.push_back({files.front(), [&](const Sink &sink) { write_particles(start, sink); }});
  if (engine_->reads_planes)
    all.push_back({files.back(), [&](const Sink &sink) {
                     sink(model.has_lid() ? lid_stl(model.box) : wall_stl(model.box));
                   }});
  write(all);
}

} // namespace mdm
