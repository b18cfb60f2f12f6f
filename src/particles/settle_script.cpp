#include "particles/settle_script.hpp"

#include "particles/particle_writer.hpp"
#include "particles/settle_state.hpp"
#include "particles/triaxial_shear.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace mdm {
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

std::string script_setting(const char *name, const std::string &value, const std::string &meaning) {
  return fmt::format("{:<46}# {}\n", fmt::format("variable {} index {}", name, value), meaning);
}

std::string digits6(double x) {
  return fmt::format("{:.6g}", x);
}

std::string digits17(double x) {
  return fmt::format("{:.17g}", x);
}

std::string filled(std::string text,
                   std::initializer_list<std::pair<const char *, std::string>> replacements) {
  for (const auto &[name, value] : replacements) {
    const std::string mark = std::string("@") + name + "@";
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  }
  return text;
}

SettleScript::SettleScript(const SettleModel &m, const char *ending)
    : model(m), set(m.set), box(m.box), physics(settling(m)), name(file_word(m.name)),
      result(name + (is_sheared() ? "-sheared" : "-settled")), dump(result + ending),
      particles(m.set.particles()) {
  if (set.unit != SizeUnit::m)
    throw InputError("a model is in SI units: leave out " + option("unit"));
}

bool SettleScript::changes_friction() const {
  return model.target.has_value() || model.friction_while_filling.has_value();
}

double SettleScript::friction_while_filling() const {
  if (!keeps_friction())
    return model.friction_while_filling.value_or(model.friction);
  double most = model.friction;
  for (const GrainMaterial &m : model.materials)
    most = std::max(most, m.friction);
  return most;
}

bool SettleScript::is_frictionless() const {
  if (model.materials.empty())
    return model.friction == 0;
  return std::all_of(model.materials.begin(), model.materials.end(),
                     [](const GrainMaterial &m) { return m.friction == 0; });
}

bool SettleScript::all_resist_rolling() const {
  if (model.materials.empty())
    return model.rolling_friction > 0;
  return std::all_of(model.materials.begin(), model.materials.end(),
                     [](const GrainMaterial &m) { return m.rolling_friction > 0; });
}

GrainMaterial SettleScript::material(std::size_t type) const {
  if (type <= model.materials.size())
    return model.materials[type - 1];
  return {physics.elasticity, Settling::restitution, model.friction, model.rolling_friction};
}

std::string SettleScript::verification(const char *engine_options) const {
  if (!model.verify_options)
    return "# mdm verify needs a gradation, and here is a band alone: only the counts are checked, as they "
           "come in.\n";
  std::string text =
      fmt::format("# Then: mdm verify GRADATION {}{}{}{}{} {}\n", dump, engine_options, *model.verify_options,
                  reaches_sieve(set) ? " --snap 1e-15" : "",
                  model.space == Space::cylinder ? fmt::format(" --specimen cylinder:{}m", box.x) : "",
                  tolerance_options(set));
  if (!model.question.empty())
    text +=
        fmt::format("# (GRADATION, --pan-size, --cut-below and --size-factor as mdm solve had them: {}.)\n",
                    comment_word(model.question));
  if (set.errors.total > 0)
    text += "# The shares of the mass are off by so many percentage points, within what was asked for.\n";
  return text;
}

namespace {

/// What the model does, after the number of grains.
std::string purpose(const SettleScript &s) {
  std::string text;
  switch (s.model.space) {
  case Space::plane:
    text = "settle between two walls";
    break;
  case Space::box:
    text = "settle in a box";
    break;
  case Space::cylinder:
    text = fmt::format("settle in a cylinder of diameter {:.6g} m", s.box.x);
    break;
  case Space::pillar:
    text = "settle in a box that is repeated in x and y";
    break;
  case Space::periodic_cell:
    text = "in a box that is repeated on all sides and has no gravity";
    break;
  case Space::six_walls:
    text = "between six walls, without gravity";
  }
  const std::optional<DensityTarget> &target = s.model.target;
  if (!target)
    return text;
  const char *by = s.has_lid()         ? ", and are compacted by a lid "
                   : s.has_six_walls() ? ", and are compacted by them "
                                       : ", and are compacted by its six faces ";
  if (target->void_ratio)
    return text + by + fmt::format("to void ratio {:.6g}", *target->void_ratio);
  text += by + fmt::format("at {:.6g} Pa", target->pressure);
  return text + (s.is_sheared() ? triaxial_purpose(s) : "");
}

/// The specimen's height at the void ratio that is asked for.
std::string height_line(const SettleScript &s) {
  if (!s.model.target || !s.model.target->void_ratio || !s.has_lid())
    return "";
  return fmt::format("# At void ratio {:.6g} the lid is {:.6g} m above the floor.\n",
                     *s.model.target->void_ratio, specimen_height(s.model, *s.model.target->void_ratio));
}

/// Nothing settles without gravity.
std::string settling_line(const SettleScript &s) {
  if (!s.has_lid())
    return "";
  const Settling &p = s.physics;
  return fmt::format(
      "# {} step{} at most while settling: {:.3g} s; a fall from the top of the box takes {:.3g} s.\n",
      p.steps, p.steps == 1 ? "" : "s", static_cast<double>(p.steps) * p.step,
      std::sqrt(2 * s.box.z / p.gravity));
}

/// The shape of the grains, where they are no spheres of their masses.
std::string law_line(const SettleScript &s) {
  if (s.model.has_discs())
    return fmt::format(
        "\n# The masses are those of discs, by the squares of their diameters. All are {:.6g} m long, two "
        "thirds of the smallest\n# diameter, and touch as spheres of their radii. Pressures and void ratios "
        "are of that length.",
        s.box.y);
  return s.set.law.is_sphere() ? "" : "\n#" + law_statement(s.set);
}

} // namespace

std::string SettleScript::head(const RunCommands &c, const std::string &contacts) const {
  return filled(R"(# @name@: @n@ @grains@ @purpose@. Written by mdm export for @engine@; SI units.
# The mass of each class is exact to @error@ of itself, the count of each is exact, and checked as it comes in.@law@
# Run it in its folder: @run@@fewer@
# @parallel@
# It writes @base@.restart@packed@ from time to time; to go on from there: @go_on@
@verification@#
# Contacts of grains:
@contacts@#
@settling@# At rest the kinetic energy of the grains is below @at_rest@ of p V, and the mean net force on one below @unbalanced@ of the
# mean contact force@without@. What is not at rest, or has fewer contacts than carry it, is no result: it ends with STOP.
@height@@triaxial@)",
                {{"name", set.name.empty() ? "grains" : comment_word(set.name)},
                 {"n", to_string(particles)},
                 {"purpose", purpose(*this)},
                 {"engine", c.engine},
                 {"error", stated_error(set)},
                 {"grains", model.has_discs() ? "discs" : "grains"},
                 {"law", law_line(*this)},
                 {"run", c.run},
                 {"fewer", has_lid() ? fmt::format("   (fewer or more steps: {})", c.fewer_steps) : ""},
                 {"parallel", c.in_parallel},
                 {"go_on", c.go_on},
                 {"verification", verification(c.verify_options)},
                 {"contacts", contacts},
                 {"settling", settling_line(*this)},
                 {"at_rest", digits6(energy_at_rest(*this))},
                 {"unbalanced", digits6(SettleLimits::unbalanced)},
                 {"without", has_lid() ? "" : ", without rattlers"},
                 {"height", height_line(*this)},
                 {"triaxial", is_sheared() ? triaxial_lines(*this) : ""},
                 {"packed", std::string(c.engine) == "YADE" ? ".gz" : ""},
                 {"base", name}});
}

} // namespace mdm
