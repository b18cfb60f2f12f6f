#include "particles/settle_script.hpp"

#include <mdm/particles/particle_writer.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace mdm {

Settling settling(const SettleModel &model) {
  Rational densest = 0;
  for (const ParticleClass &c : model.set.classes)
    densest = std::max(densest, c.density);
  Settling s;
  const double weight = densest.convert_to<double>() * s.gravity * model.box.z;
  s.elasticity.young = model.young ? *model.young : Rational(std::max(5e6, std::ceil(1e4 * weight)));
  s.elasticity.poisson = model.poisson;
  s.rayleigh = rayleigh_time(model.set, s.elasticity).convert_to<double>();
  s.step = s.part_of_rayleigh * s.rayleigh;
  const double falls = model.deposited ? 1 : 3;
  const double steps = model.steps ? static_cast<double>(*model.steps)
                                   : std::ceil(falls * std::sqrt(2 * model.box.z / s.gravity) / s.step);
  if (steps > Settling::most_steps)
    throw InputError(
        fmt::format("{:.3g} steps are more than the {} that LAMMPS and LIGGGHTS make in a run: give "
                    "fewer --steps, a softer --young, or a lower --box",
                    steps, Settling::most_steps));
  s.steps = static_cast<std::uint64_t>(steps);
  return s;
}

std::string share_tolerance(const ParticleSet &set) {
  // Masses m_j (1 + e_j), |e_j| <= e, have shares within 2 e / (1 - e); 17 digits of a dump, and a snap, add
  // a little.
  const Rational e = set.mass_error() + ratio(1 + set.law.a, power_of_ten(15));
  const Rational points = 100 * 2 * e / (1 - std::min(e, ratio(1, 2)));
  unsigned places = 0;
  while (points * power_of_ten(places) < 1)
    ++places;
  return short_decimal(ceil(Rational((100 * set.share_error + points) * power_of_ten(places))),
                       static_cast<int>(places));
}

namespace {

/// True if a size is so near to the upper sieve of its class that 17 digits of it may lie above.
bool reaches_sieve(const ParticleSet &set) {
  constexpr double nearly = 1 - 1e-15; // what is farther away than that, rounding leaves below
  for (const ParticleClass &c : set.classes) {
    const double most = nearly * c.upper.convert_to<double>();
    for (const ParticleSize &size : c.sizes)
      if (std::max(size.diameter.value, 2 * size.radius.value) > most)
        return true;
  }
  return false;
}

} // namespace

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
    : set(m.set), box(m.box), physics(settling(m)), young(physics.elasticity.young.convert_to<double>()),
      poisson(physics.elasticity.poisson.convert_to<double>()), dump(file_word(m.dump)), seed(m.seed),
      verify_options(m.verify_options), question(m.question), is_softer(!m.young), sides(m.sides),
      particles(m.set.particles()) {
  if (set.unit != LengthUnit::m)
    throw InputError("a model is in SI units: leave out --unit");
}

std::string SettleScript::verification(const char *engine_options) const {
  if (!verify_options)
    return "# mdm verify needs a gradation, and here is a band alone: only the counts are checked, as they "
           "come in.\n";
  std::string text =
      fmt::format("# Then: mdm verify GRADATION {}{}{}{} --tolerance {}\n", dump, engine_options,
                  *verify_options, reaches_sieve(set) ? " --snap 1e-15" : "", share_tolerance(set));
  if (!question.empty())
    text +=
        fmt::format("# (GRADATION, --pan-size, --cut-below and --size-factor as mdm solve had them: {}.)\n",
                    comment_word(question));
  if (set.share_error > 0)
    text += "# The shares of the mass are off by that many percentage points, as was asked for.\n";
  return text;
}

std::string SettleScript::head(const char *engine, const char *command, const char *more_steps,
                               const char *engine_options) const {
  return fmt::format(
      R"(# {name}: {n} grains settle in a box. Written by mdm export for {engine}; SI units.
# The mass of each class is exact to {error} of itself, the count of each is exact, and checked as it comes in.{law}
# Run it in its folder: {command}   (fewer or more steps: {more_steps})
{verification}#
# Material: E = {young:.4g} Pa, nu = {nu}, restitution {e}, friction {mu}.{softness}
# Time step: a fifth of the Rayleigh time of the smallest grain,
# pi R sqrt(rho/G) / (0.1631 nu + 0.8766) = {rayleigh:.4g} s with G = E / (2 (1 + nu)).
# {steps} step{plural}: {time:.3g} s; a fall from the top of the box takes {fall:.3g} s.
)",
      fmt::arg("name", set.name.empty() ? "grains" : comment_word(set.name)),
      fmt::arg("n", to_string(particles)), fmt::arg("engine", engine), fmt::arg("error", stated_error(set)),
      fmt::arg("law", set.law.is_sphere() ? "" : "\n#" + law_statement(set)), fmt::arg("command", command),
      fmt::arg("more_steps", more_steps), fmt::arg("verification", verification(engine_options)),
      fmt::arg("young", young), fmt::arg("nu", poisson), fmt::arg("e", physics.restitution),
      fmt::arg("mu", physics.friction),
      fmt::arg("softness", is_softer ? " E is softer than rock to save steps:\n# 10^4 times the weight of a "
                                       "column as high as the box, 5 MPa at least."
                                     : ""),
      fmt::arg("rayleigh", physics.rayleigh), fmt::arg("steps", physics.steps),
      fmt::arg("plural", physics.steps == 1 ? "" : "s"),
      fmt::arg("time", static_cast<double>(physics.steps) * physics.step),
      fmt::arg("fall", std::sqrt(2 * box.z / physics.gravity)));
}

} // namespace mdm
