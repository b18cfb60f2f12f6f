#include "particles/settle_model.hpp"

#include "particles/particle_writer.hpp"
#include "particles/settle_state.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mdm {

namespace {

/// Young's modulus is this many times the highest pressure while compacting.
constexpr double stiffness_by_pressure = 2000;

double mass(const SettleModel &model) {
  double sum = 0;
  for (const ParticleClass &c : model.set.classes)
    for (const ParticleSize &size : c.sizes) {
      const double d = size.diameter.value;
      const double volume = std::numbers::pi * d * d * (model.has_discs() ? model.box.y / 4 : d / 6);
      sum += c.density.convert_to<double>() * size.quantity.convert_to<double>() * volume;
    }
  return sum;
}

/// Volume of the grains.
double solids_of(const SettleModel &model) {
  return model.has_discs() ? std::numbers::pi / 4 * model.box.y * model.set.squares().convert_to<double>()
                           : std::numbers::pi / 6 * model.set.cubes().convert_to<double>();
}

/// The diameter of a grain of the mean volume.
double mean_size(const SettleModel &model, double solids) {
  const double of_grain = solids / model.set.particles().convert_to<double>();
  return model.has_discs() ? std::sqrt(4 / std::numbers::pi * of_grain / model.box.y)
                           : std::cbrt(6 / std::numbers::pi * of_grain);
}

/// Of the material that is the least favourable, where classes differ.
double rayleigh_of(const SettleModel &model, const Elasticity &elasticity) {
  if (model.materials.empty())
    return rayleigh_time(model.set, elasticity).convert_to<double>();
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < model.set.classes.size(); ++i) {
    const Rational time = rayleigh_time(model.set, model.set.classes[i], model.materials[i].elasticity);
    least = std::min(least, time.convert_to<double>());
  }
  return least;
}

/// The steps of compaction: a strain at the greatest rate, and friction that is lowered meanwhile.
void set_compaction(const SettleModel &model, double softest_young, Settling &s) {
  const DensityTarget &target = *model.target;
  s.most_pressure = target.void_ratio ? softest_young / stiffness_by_pressure : target.pressure;
  s.least_pressure = SettleLimits::stiffness_share * softest_young;
  const double size = mean_size(model, s.solids);
  const double density = mass(model) / s.solids;
  s.rate = compaction_inertia(model) / (size * std::sqrt(density / s.most_pressure));
  // Walls push from outside: the more grains there are between them, the slower.
  constexpr double grains_between = 20;
  if (model.has_six_walls())
    s.rate /= std::max(1.0, std::cbrt(model.set.particles().convert_to<double>()) / grains_between);
  constexpr double usual_strain = 0.2, friction_steps = 100.0 * static_cast<double>(compaction_look),
                   ample = 10;
  const double expected = usual_strain / (s.rate * s.step) + friction_steps;
  s.compacting = static_cast<std::uint64_t>(std::min<double>(expected, Settling::most_steps));
  s.most_compacting = static_cast<std::uint64_t>(std::min<double>(ample * expected, Settling::most_steps));
}

double softened_young(const SettleModel &model) {
  Rational densest = 0;
  for (const ParticleClass &c : model.set.classes)
    densest = std::max(densest, c.density);
  const double weight = densest.convert_to<double>() * Settling::gravity * model.box.z;
  const double pressure = model.target && !model.target->void_ratio ? model.target->pressure : 0;
  return std::max({5e6, std::ceil(1e4 * weight), std::ceil(stiffness_by_pressure * pressure)});
}

/// The percentage points of an error, and what rounded masses add to it, rounded up.
std::string points_text(const ParticleSet &set, const Rational &error) {
  // Masses m_j (1 + e_j), |e_j| <= e, have shares within 2 e / (1 - e); 17 digits of a dump, and a snap, add
  // a little.
  const Rational e = set.mass_error() + (1 + set.law.steepness()) / Rational(power_of_ten(15));
  const Rational points = 100 * 2 * e / (1 - std::min(e, ratio(1, 2)));
  unsigned places = 0;
  while (points * power_of_ten(places) < 1)
    ++places;
  return short_decimal(ceil(Rational((100 * error + points) * power_of_ten(places))),
                       static_cast<int>(places));
}

} // namespace

bool SettleModel::resists_rolling() const {
  return rolling_friction > 0 || std::any_of(materials.begin(), materials.end(),
                                             [](const GrainMaterial &m) { return m.rolling_friction > 0; });
}

Elasticity SettleModel::softest(const Elasticity &without_materials) const {
  if (materials.empty())
    return without_materials;
  return std::min_element(materials.begin(), materials.end(),
                          [](const GrainMaterial &a, const GrainMaterial &b) {
                            return a.elasticity.young < b.elasticity.young;
                          })
      ->elasticity;
}

double compaction_inertia(const SettleModel &model) {
  return model.has_discs() ? 0.001 : 0.003;
}

Settling settling(const SettleModel &model) {
  Settling s;
  s.elasticity.young = model.young ? *model.young : Rational(softened_young(model));
  s.elasticity.poisson = model.poisson;
  s.rayleigh = rayleigh_of(model, s.elasticity);
  s.step = s.part_of_rayleigh * s.rayleigh;
  constexpr double falls = 5;
  const double steps = model.steps ? static_cast<double>(*model.steps)
                                   : std::ceil(falls * std::sqrt(2 * model.box.z / s.gravity) / s.step);
  if (steps > Settling::most_steps)
    throw InputError(
        fmt::format("{:.3g} steps are more than the {} that LAMMPS and LIGGGHTS make in a run: give "
                    "fewer {}, a softer {}, or a lower {}",
                    steps, Settling::most_steps, option("steps"), option("young"), option("box")));
  s.steps = static_cast<std::uint64_t>(steps);
  const double smallest = model.set.smallest().diameter.value;
  constexpr double part_of_size = 0.1;
  s.look = static_cast<std::uint64_t>(
      std::clamp<double>(std::ceil(std::sqrt(2 * part_of_size * smallest / s.gravity) / s.step), 100, 1e8));
  s.solids = solids_of(model);
  s.floor_moment = mass(model) * s.gravity * smallest / 2;
  if (model.target)
    set_compaction(model, model.softest(s.elasticity).young.convert_to<double>(), s);
  return s;
}

CohesiveContact smallest_contact(const SettleModel &model, const Elasticity &elasticity,
                                 const CohesionLaw &law) {
  return law.contact(model.cohesion, model.set.smallest().radius.value, model.softest(elasticity));
}

double disc_length(const ParticleSet &set) {
  return set.smallest().diameter.value * 2 / 3;
}

double specimen_height(const SettleModel &model, double void_ratio) {
  if (model.has_discs())
    return (1 + void_ratio) * solids_of(model) / (model.box.x * model.box.y);
  // Both have pi / 6 or pi / 4.
  const double cubes = model.set.cubes().convert_to<double>() / (model.box.x * model.box.y);
  return (1 + void_ratio) * cubes * (model.space == Space::cylinder ? 2.0 / 3 : std::numbers::pi / 6);
}

std::string share_tolerance(const ParticleSet &set) {
  return points_text(set, set.errors.retained);
}

std::string tolerance_options(const ParticleSet &set) {
  const std::string retained = "--tolerance " + share_tolerance(set);
  if (set.errors.total == 0 || set.has_materials())
    return retained;
  return retained + " --tolerance passing:" + points_text(set, set.errors.passing) +
         " --tolerance total:" + points_text(set, set.errors.total);
}

} // namespace mdm
