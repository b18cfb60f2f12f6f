#include "cli/export_model.hpp"

#include "cli/files.hpp"
#include "text/lines.hpp"

#include <mdm/particles/particle_writer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <filesystem>
#include <numbers>

namespace mdm::cli {

struct ModelEngine {
  const char *name;
  std::string (*script)(const SettleModel &);
  bool inserts; ///< by itself, where there is no start
  void (*write_particles)(const Placement &, const Sink &);
  const char *particles_ending;
  const char *dump_ending;
};

namespace {

constexpr std::array<ModelEngine, 3> engines = {
    {{"liggghts", liggghts_model, true, write_lammps_data, ".data", ".dump"},
     {"lammps", lammps_model, false, write_lammps_data, ".data", ".dump"},
     {"yade", yade_model, false, write_xyzr, ".xyzr", ".xyzr"}}};

ModelBox insertion_box(const ParticleSet &set, const std::optional<Footprint> &floor) {
  const double largest = set.largest().diameter.value;
  ModelBox box;
  box.x = floor ? floor->a.convert_to<double>() : settled_side(set);
  box.y = floor ? floor->b.convert_to<double>() : box.x;
  const bool has_height = floor && floor->c;
  box.z = has_height ? floor->c->convert_to<double>() : 0;
  if (std::min(box.x, box.y) <= largest || (has_height && box.z <= largest))
    throw InputError(fmt::format("--box: the largest grain, {} m, does not fit into it: give a larger one",
                                 set.largest().diameter.text));
  if (!has_height)
    box.z = insertion_height(set, box.x, box.y);
  // LIGGGHTS itself finds out, and says so, where there is a little more room than this.
  const double grains = std::numbers::pi / 6 * set.cubes().convert_to<double>();
  if (grains >= box.x * box.y * box.z)
    throw InputError(
        fmt::format("--box: the grains have a volume of {:.3g} m^3, the box one of {:.3g} m^3: leave "
                    "its height out, or give a larger one",
                    grains, box.x * box.y * box.z));
  return box;
}

} // namespace

ModelWriter::ModelWriter(const std::string &model, const std::string &to, std::string out, bool has_start)
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
  if (has_start || !engine_->inserts)
    particles_ = std::filesystem::path(out_).replace_extension(engine_->particles_ending).string();
}

SettleModel ModelWriter::model(const ParticleSet &set, const std::optional<Placement> &start,
                               const std::optional<Footprint> &floor) const {
  const auto length = [&start](std::size_t axis) {
    return std::strtod(start->text(start->box()[axis]).c_str(), nullptr);
  };
  const ModelBox box = start ? ModelBox{length(0), length(1), length(2)} : insertion_box(set, floor);
  return {set, box, std::filesystem::path(particles_).filename().string(),
          std::filesystem::path(out_).stem().string() + "-settled" + engine_->dump_ending};
}

void ModelWriter::write(const SettleModel &model, const std::optional<Placement> &start) const {
  assert(start || particles_.empty());
  Output script(out_);
  script.write(engine_->script(model));
  if (start) {
    Output particles(particles_);
    engine_->write_particles(*start, [&particles](std::string_view text) { particles.write(text); });
    particles.commit();
  }
  script.commit();
}

} // namespace mdm::cli
