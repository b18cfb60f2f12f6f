#include "cli/export_model.hpp"

#include "ask/option_values.hpp"
#include "files/byte_source.hpp"
#include "files/output.hpp"
#include "files/paths.hpp"
#include "particles/material_table.hpp"
#include "particles/particle_writer.hpp"
#include "text/lines.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>

namespace mdm::cli {

struct ModelEngine {
  const char *name;
  std::string (*script)(const SettleModel &);
  void (*write_particles)(const Placement &, const Sink &);
  void (*write_classes)(const Placement &, const Sink &); ///< with a type a class
  const char *particles_ending;
  bool reads_lid;
};

namespace {

constexpr std::array<ModelEngine, 3> engines = {
    {{"liggghts", liggghts_model, write_lammps_data, write_lammps_data_of_classes, ".data", true},
     {"lammps", lammps_model, write_lammps_data, write_lammps_data_of_classes, ".data", false},
     {"yade", yade_model, write_xyzr, write_xyzr, ".xyzr", false}}};

constexpr std::size_t most_material_bytes = 1000000;

/// A coefficient of friction.
std::optional<double> friction(const char *name, const OptionText &text) {
  if (!text)
    return std::nullopt;
  const Rational mu = not_negative(name, *text);
  if (mu > 10)
    throw InputError(option(name) + ": " + in_quotes(*text) + " is no coefficient of friction: give 0 to 10");
  return mu.convert_to<double>();
}

std::optional<DensityTarget> density_target(const ExportCommand &c) {
  if (!c.flags.void_ratio && !c.pressure)
    return std::nullopt;
  DensityTarget target;
  if (c.flags.void_ratio) {
    const Rational e = positive("void-ratio", *c.flags.void_ratio);
    if (e > 100)
      throw InputError("--void-ratio: " + in_quotes(*c.flags.void_ratio) + " is above 100, which no bed has");
    target.void_ratio = e.convert_to<double>();
  } else
    target.pressure = physical("stress", *c.pressure).convert_to<double>();
  if (c.tolerance) {
    const Rational tolerance = positive("target-tolerance", *c.tolerance);
    if (tolerance >= 1 || tolerance < ratio(1, 1000000))
      throw InputError("--target-tolerance: " + in_quotes(*c.tolerance) + " is not from 1e-6 to below 1");
    target.tolerance = tolerance.convert_to<double>();
  }
  return target;
}

std::uint64_t steps_of(const std::string &text) {
  const Integer steps = natural("steps", text, 0);
  if (steps > Settling::most_steps)
    throw InputError(
        fmt::format("--steps: {} are more than the {} that LAMMPS and LIGGGHTS make in a run: give "
                    "fewer --steps",
                    in_quotes(text), Settling::most_steps));
  return static_cast<std::uint64_t>(steps);
}

} // namespace

ModelWriter::ModelWriter(const std::string &model, const std::string &to, std::string out)
    : engine_(std::find_if(engines.begin(), engines.end(),
                           [&to](const ModelEngine &engine) { return to == engine.name; })),
      out_(std::move(out)) {
  if (model != "settle")
    throw InputError("--model: " + in_quotes(model) + " is none: there is settle");
  if (engine_ == engines.end())
    throw InputError("--model: there is none for " + to + ": use --to liggghts, lammps or yade");
  if (out_ == "-")
    throw InputError("--model: what it reads and writes lies beside it: say where with -o FILE");
  if (engine_->script == yade_model && std::filesystem::path(out_).extension() != ".py")
    throw InputError("-o: YADE runs models that end in .py: give it such a name");
  std::error_code none;
  if (const auto type = std::filesystem::status(out_, none).type();
      type != std::filesystem::file_type::not_found && type != std::filesystem::file_type::regular)
    throw InputError("-o: " + printable(out_) +
                     " is no regular file, beside which a model's other files could lie: give another name");
}

std::vector<std::string> ModelWriter::other_files() const {
  const std::filesystem::path out(out_);
  std::vector<std::string> files{
      std::filesystem::path(out).replace_extension(engine_->particles_ending).string()};
  if (engine_->reads_lid)
    files.push_back((out.parent_path() / (out.stem().string() + "-lid.stl")).string());
  return files;
}

SettleModel ModelWriter::model(const ExportCommand &c, const ExportedParticles &found,
                               const Placement &start) const {
  const auto length = [&start](std::size_t axis) {
    return std::strtod(start.text(start.box()[axis]).c_str(), nullptr);
  };
  SettleModel model{*found.set,
                    {length(0), length(1), length(2)},
                    std::filesystem::path(other_files().front()).filename().string(),
                    std::filesystem::path(out_).stem().string()};
  model.space = space(c);
  model.target = density_target(c);
  if (c.steps)
    model.steps = steps_of(*c.steps);
  const Elasticity e = elasticity(c);
  if (c.young)
    model.young = e.young;
  model.poisson = e.poisson;
  model.friction = friction("friction", c.friction).value_or(model.friction);
  model.friction_while_filling = friction("friction-while-filling", c.friction_while_filling);
  model.types_of_classes = c.types == "class" || c.material;
  if (c.material)
    model.materials =
        read_materials(read_file(*c.material, most_material_bytes), shown_name(*c.material), *found.set,
                       {settling(model).elasticity, Settling::restitution, model.friction});
  model.verify_options = verify_options(c);
  model.question = found.question;
  return model;
}

void ModelWriter::write(const SettleModel &model, const Placement &start) const {
  Output script(out_);
  script.write(engine_->script(model));
  const std::vector<std::string> files = other_files();
  Output particles(files.front());
  (model.types_of_classes ? engine_->write_classes : engine_->write_particles)(
      start, [&particles](std::string_view text) { particles.write(text); });
  if (engine_->reads_lid) {
    Output lid(files.back());
    lid.write(lid_stl(model.box));
    lid.commit();
  }
  particles.commit();
  script.commit();
}

} // namespace mdm::cli
