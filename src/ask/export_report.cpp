#include "ask/export_report.hpp"

#include "number/counted.hpp"
#include "particles/triaxial_shear.hpp"
#include "text/file_names.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mdm {
namespace {

/// Above this number, --yes-huge is required.
constexpr std::uint64_t huge = 10000000;
/// Boxes and sizes beyond these, in m, are mostly wrong units.
const Rational &largest_box() {
  static const Rational side = 100;
  return side;
}
const Rational &smallest_size() {
  static const Rational micrometre = ratio(1, 1000000);
  return micrometre;
}

/// \throws InputError if a side of that many metres looks like a mistake
void check_side(const ExportTexts &c, const Rational &side) {
  if (!c.yes_units && side > largest_box())
    throw InputError("the particles need a box of " + approximate(side, 3) +
                     " m, more than 100 m: is the unit of the gradation right, and " + option("box") +
                     " wide enough? " + option("yes-units") + " if they are");
}

/// `1.5 MB`, three digits of it.
std::string bytes_text(const Integer &bytes) {
  constexpr int step = 1000;
  Rational n = bytes;
  std::size_t i = 0;
  constexpr std::array<const char *, 5> units = {"bytes", "kB", "MB", "GB", "TB"};
  for (; n >= step && i + 1 < units.size(); ++i)
    n /= step;
  return approximate(n, 3) + " " + units.at(i);
}

/// Densities that few grains have are mostly factors in other units.
std::string odd_densities(const ParticleSet &set) {
  const Rational least_usual = 100, most_usual = 6000;
  const auto [least, most] = std::minmax_element(
      set.classes.begin(), set.classes.end(),
      [](const ParticleClass &a, const ParticleClass &b) { return a.density < b.density; });
  const Rational in_cubic_metre = power(in_metres(set, 1), 3);
  const Rational lo = least->density / in_cubic_metre, hi = most->density / in_cubic_metre;
  if (lo >= least_usual && hi <= most_usual)
    return "";
  if (lo == hi)
    return fmt::format(
        "density: {} kg/m^3, which few grains have: {} is in kg/m^3, such as 2650, and a factor "
        "of the gradation multiplies it\n",
        approximate(lo, 4), option("density"));
  return fmt::format(
      "densities: {} to {} kg/m^3, {} times the factors of the gradation, where it has some: give 1 where "
      "these are in kg/m^3, 1000 where they are in g/cm^3\n",
      approximate(lo, 4), approximate(hi, 4), option("density"));
}

/// The digits that two bounds of a number have in common, four at most.
std::string certain_digits(const std::pair<Rational, Rational> &bounds) {
  unsigned digits = 4;
  while (digits > 1 && approximate(bounds.first, digits) != approximate(bounds.second, digits))
    --digits;
  return approximate(bounds.first, digits);
}

/// Of the steps that are allowed: beds mostly come to rest, and reach their density, before.
constexpr double usual_part = 0.5;

/// Runs above these seconds are long.
constexpr double long_run = 600;

std::string time_text(double seconds) {
  constexpr double minute = 60, hour = 3600, day = 86400;
  if (seconds < 2 * minute)
    return fmt::format("some {:.2g} s", seconds);
  if (seconds < 2 * hour)
    return fmt::format("some {:.2g} minutes", seconds / minute);
  return seconds < 3 * day ? fmt::format("some {:.2g} hours", seconds / hour)
                           : fmt::format("some {:.2g} days", seconds / day);
}

/// What makes a long run shorter.
std::string cheaper(const ExportFormat &format, const SettleModel &model, double seconds) {
  const std::string parallel = format.id == ExportTo::yade       ? "yade -n -j 4"
                               : format.id == ExportTo::liggghts ? "mpirun -np 4 liggghts -in"
                                                                 : "mpirun -np 4 lmp -in";
  constexpr double tenfold = 10;
  std::string text = fmt::format("shorter: {} FILE;", parallel);
  if (model.materials.empty())
    text += fmt::format(" {} {} takes {}, with overlaps 4.6 times as large;", option("young"),
                        short_decimal(Rational(settling(model).elasticity.young / 10)),
                        time_text(seconds / std::sqrt(tenfold)));
  return text + " a larger smallest sieve (" + option("cut-below") + ") or a " + option("tolerance") +
         " needs fewer grains and longer steps, see mdm tradeoff; in quasi-static runs a " +
         option("density") + " 100 times as high takes a tenth of the steps, and weighs 100 times as much\n";
}

} // namespace

void check_wanted(const ExportTexts &c, const ExportFormat &format, const ParticleSet &set,
                  const Placement *start) {
  if (c.model && set.has_materials())
    throw InputError(
        option("model") +
        ": it tells classes by their sizes, and those of several materials overlap: leave it out; "
        "with " +
        option("to") + " lammps " + option("types") + " class each has a type");
  if (!c.yes_huge && set.particles() > huge && format.id != ExportTo::csv)
    throw InputError(fmt::format("{} particles are more than {}: {} if that is wanted; else a {} or {} needs "
                                 "fewer, and {} csv writes counts alone",
                                 to_string(set.particles()), huge, option("yes-huge"), option("tolerance"),
                                 option("cut-below"), option("to")));
  if (format.bytes > 0)
    check_simulated(set);
  if (c.yes_units)
    return;
  const Rational smallest = in_metres(set, set.smallest().diameter.decimal());
  if (smallest < smallest_size())
    throw InputError("particles of " + approximate(smallest, 3) +
                     " m are below 1 um: is the unit of the gradation right? " + option("yes-units") +
                     " if it is, " + option("cut-below") + " leaves fine classes out");
  Rational side = loose_side(set);
  if (start)
    for (const std::int64_t length : start->box())
      side = std::max(side, in_metres(set, parse_decimal(start->text(length))));
  check_side(c, side);
}

std::string cost_guide(const ExportFormat &format, const ParticleSet &set, const Placement *start,
                       const Elasticity &e) {
  std::string text =
      fmt::format("{}; Rayleigh time {} s (E = {} Pa, nu = {}): take some 20 % of it as time step\n",
                  counted(set.particles()), approximate(rayleigh_time(set, e), 3), short_decimal(e.young),
                  short_decimal(e.poisson));
  if (format.bytes > 0)
    text += fmt::format("memory of {}: some {} ({} bytes a particle, more where sizes are far apart)\n",
                        format.name, bytes_text(Integer(set.particles() * format.bytes)), format.bytes);
  if (format.id == ExportTo::mercurydpm)
    text += "MercuryDPM draws sizes at random from the shares: its counts are not exact\n";
  if (format.has_floats)
    text += fmt::format("sizes are floats, each in its class; masses are within {} of the exact ones, places "
                        "as near as floats are\n",
                        stated_error(set));
  if (format.id == ExportTo::phasicflow)
    text +=
        "it goes into the case's settings as particlesDict, what ends in -shapes into caseSetup as shapes, "
        "what ends in -positions into the case itself as positions; the material is called grains\n";
  if (format.id == ExportTo::dem_engine)
    text += "each clump_type is r and a radius: give it to DEM-Engine by LoadSphereType(mass, radius, "
            "material)->AssignName(clump_type)\n";
  text += odd_densities(set);
  if (!format.has_comments && !set.law.is_sphere())
    text += law_statement(set).substr(1) + "\n";
  if (start)
    text +=
        fmt::format("{}: {} x {} x {} {}{}, void ratio {}; {}\n",
                    start->sides() == Sides::cylinder ? "cylinder in a box" : "box",
                    start->text(start->box()[0]), start->text(start->box()[1]), start->text(start->box()[2]),
                    name(set.unit), start->repeated_text(), certain_digits(start->void_ratio()),
                    start->is_kept()    ? "the particles are where they were"
                    : format.has_floats ? "no two particles overlap by more than places are rounded"
                                        : "no two particles overlap");
  return text;
}

std::string how_to_verify(const ExportTexts &c, const ExportFormat &format, const ExportedParticles &found,
                          const Placement *start) {
  const ParticleSet &set = *found.set;
  const std::optional<std::string> options = verify_options(c);
  const bool loses_materials = set.has_materials() && format.id != ExportTo::csv;
  if (!options || !found.has_gradation || c.file == "-" || c.out == "-" || loses_materials ||
      format.id == ExportTo::mercurydpm)
    return "";
  const std::string unit = format.id == ExportTo::csv ? "" : " --size-unit " + std::string(name(set.unit));
  const std::string specimen =
      start != nullptr && start->sides() == Sides::cylinder
          ? fmt::format(" --specimen cylinder:{}{}", start->text(start->box()[0]), name(set.unit))
          : "";
  return fmt::format("check it by: mdm verify {} {}{}{}{} {}\n", shell_word(*c.file), shell_word(c.out),
                     *options, unit, specimen, tolerance_options(set));
}

std::string model_guide(const ExportFormat &format, const SettleModel &model) {
  const Settling s = settling(model);
  std::string text = "model:";
  std::uint64_t steps = 0;
  if (model.has_lid()) {
    steps = s.steps;
    text += fmt::format(" at most {} step{} while settling;", s.steps, s.steps == 1 ? "" : "s");
  }
  if (model.target) {
    steps += s.compacting;
    text += fmt::format(" some {} steps of compaction;", s.compacting);
  }
  if (model.shear) {
    const std::uint64_t shearing = ShearCourse(model).steps;
    // The part of steps that are made is one of those that are allowed: these are all made.
    steps += static_cast<std::uint64_t>(static_cast<double>(shearing) / usual_part);
    text += fmt::format(" {} steps of shear;", shearing);
  }
  const double seconds =
      usual_part * model.set.particles().convert_to<double>() * static_cast<double>(steps) / format.rate;
  text += fmt::format(" a step is {:.3g} s; {} of a core of 2.1 GHz at {:.2g} grains by steps a second\n",
                      s.step, time_text(seconds), format.rate);
  if (model.target && model.target->void_ratio && model.has_lid())
    text += fmt::format("at void ratio {:.6g} the specimen is {:.6g} m high\n", *model.target->void_ratio,
                        specimen_height(model, *model.target->void_ratio));
  if (seconds > long_run)
    text += cheaper(format, model, seconds);
  return text + "its first lines say how to run it and to verify what it leaves\n";
}

} // namespace mdm
