#include "settle_script.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mdm {

using std::numbers::pi;

Settling settling(const ParticleSet &set, double height) {
  double densest = 0, least = INFINITY; // of R sqrt(rho)
  for (const ParticleClass &c : set.classes) {
    const double density = c.density.convert_to<double>();
    densest = std::max(densest, density);
    least = std::min(least, c.sizes.front().radius.value * std::sqrt(density));
  }
  Settling s;
  s.young = std::max(5e6, 1e4 * densest * s.gravity * height);
  const double shear = s.young / (2 * (1 + s.poisson));
  s.rayleigh = pi * least / std::sqrt(shear) / (0.1631 * s.poisson + 0.8766);
  s.step = s.part_of_rayleigh * s.rayleigh;
  s.steps = static_cast<std::uint64_t>(std::ceil(3 * std::sqrt(2 * height / s.gravity) / s.step));
  return s;
}

double insertion_height(const ParticleSet &set, double x, double y) {
  constexpr double most_part = 0.8;
  std::vector<const ParticleSize *> placed; // those that are there when a size is inserted, and itself
  double height = 0;
  for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c)
    for (auto size = c->sizes.rbegin(); size != c->sizes.rend(); ++size) {
      placed.push_back(&*size);
      const double d = size->diameter.value;
      double kept_free = 0;
      for (const ParticleSize *other : placed)
        kept_free += other->quantity.convert_to<double>() * pi / 6 * std::pow(other->diameter.value + d, 3);
      height = std::max(height, d + kept_free / (most_part * (x - d) * (y - d)));
    }
  return height;
}

std::string share_tolerance(const ParticleSet &set) {
  // Masses m_j (1 + e_j), |e_j| <= e, have shares within 2 e / (1 - e); 17 digits of a dump add a little.
  const double e = set.mass_error().convert_to<double>() + 1e-15;
  const double points = 100 * 2.001 * e;
  const int places = -static_cast<int>(std::floor(std::log10(points)));
  return short_decimal(Integer(std::ceil(points * std::pow(10, places))), places);
}

std::string file_word(const std::string &name) {
  const bool plain = !name.empty() && name[0] != '-' && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-' || c == '+';
  });
  if (!plain)
    throw InputError(
        "a model's files have names of letters, digits and . _ - + alone, which no engine takes for "
        "its own signs: give such a name to -o");
  return name;
}

std::string comment_word(const std::string &text) {
  std::string word;
  for (const char c : text)
    word += c >= ' ' && c <= '~' && std::string_view("&$`\\\"'").find(c) == std::string_view::npos ? c : '_';
  return word;
}

std::string class_name(const ParticleClass &c) {
  return fmt::format("class {} ({}, {}]", c.number, short_decimal(c.lower), short_decimal(c.upper));
}

SettleScript::SettleScript(const SettleModel &m)
    : set(m.set), box(m.box), physics(settling(m.set, m.box.z)), dump(file_word(m.dump)), seed(m.seed),
      steps(m.steps.value_or(physics.steps)), particles(m.set.particles()) {
  if (set.unit != LengthUnit::m)
    throw InputError("a model is in SI units: leave out --unit");
  // Counts are 32-bit numbers in LIGGGHTS, and ids are in LAMMPS.
  if (particles > 2147483647)
    throw InputError(
        fmt::format("the engine counts up to 2147483647, and these are {} particles: solve with a "
                    "tolerance or without the finest classes",
                    to_string(particles)));
}

std::string SettleScript::head(const char *engine, const char *command, const char *more_steps,
                               const char *verify_options) const {
  return fmt::format(
      R"(# {name}: {n} grains settle in a box. Written by mdm export for {engine}; SI units.
# The mass of each class is exact to {error} of itself, the count of each is exact, and checked as it comes in.
# Run it in its folder: {command}   (fewer or more steps: {more_steps})
# Then: mdm verify GRADATION {dump}{verify_options} --tolerance {tolerance}
#
# Material: E = {young:.4g} Pa, nu = {nu}, restitution {e}, friction {mu}. E is softer than rock to save steps: 10^4 times
# the weight of a column as high as the box, 5 MPa at least.
# Time step: a fifth of the Rayleigh time of the smallest grain,
# pi R sqrt(rho/G) / (0.1631 nu + 0.8766) = {rayleigh:.4g} s with G = E / (2 (1 + nu)).
# {steps} steps: {time:.3g} s; a fall from the top of the box takes {fall:.3g} s.
)",
      fmt::arg("name", set.name.empty() ? "grains" : comment_word(set.name)),
      fmt::arg("n", to_string(particles)), fmt::arg("engine", engine),
      fmt::arg("error", fmt::format("{:.1e}", set.mass_error().convert_to<double>())),
      fmt::arg("command", command), fmt::arg("more_steps", more_steps), fmt::arg("dump", dump),
      fmt::arg("verify_options", verify_options), fmt::arg("tolerance", share_tolerance(set)),
      fmt::arg("young", physics.young), fmt::arg("nu", physics.poisson), fmt::arg("e", physics.restitution),
      fmt::arg("mu", physics.friction), fmt::arg("rayleigh", physics.rayleigh), fmt::arg("steps", steps),
      fmt::arg("time", static_cast<double>(steps) * physics.step),
      fmt::arg("fall", std::sqrt(2 * box.z / physics.gravity)));
}

} // namespace mdm
