#include "particles/particle_writer.hpp"

#include "text/long_text.hpp"
#include "text/option_name.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// `2650 kg/m^3` in the unit of the set, or from the least to the greatest where classes differ.
std::string densities(const ParticleSet &set) {
  Rational least = set.classes.front().density, most = least;
  for (const ParticleClass &c : set.classes) {
    least = std::min(least, c.density);
    most = std::max(most, c.density);
  }
  return fmt::format("{}{} kg/{}^3", short_decimal(least), least == most ? "" : " to " + short_decimal(most),
                     name(set.unit));
}

} // namespace

std::string title(const ParticleSet &set) {
  // The first words keep a name from looking like the head of another format.
  return fmt::format("Particles of {}: {} in {} class{}, by exactmdm; lengths in {}, density {}",
                     set.name.empty() ? "a gradation" : printable(set.name), to_string(set.particles()),
                     set.classes.size(), set.classes.size() == 1 ? "" : "es", name(set.unit), densities(set));
}

std::string stated_error(const ParticleSet &set) {
  constexpr int least = 100; // of three digits
  const Rational error = set.mass_error();
  int places = 0;
  if (error > 0)
    while (error * power_of_ten(static_cast<unsigned>(places)) < least)
      ++places;
  return short_decimal(ceil(Rational(error * power_of_ten(static_cast<unsigned>(places)))), places);
}

std::string mass_statement(const ParticleSet &set) {
  return fmt::format("The mass of each class is that of the exact sizes within {} of it.",
                     stated_error(set)) +
         law_statement(set);
}

std::string law_statement(const ParticleSet &set) {
  if (set.law.is_sphere())
    return "";
  return fmt::format(" Masses are by {}: {}{}. Spheres of these sizes have others, by x^3.", option("law"),
                     set.law.formula(set.unit), set.law.is_power() ? " of a size x" : "");
}

std::string comment_lines(const ParticleSet &set) {
  return "# " + title(set) + "\n# " + mass_statement(set) + "\n";
}

void write_size_csv(const ParticleSet &set, const Sink &out) {
  LongText text(out);
  const bool has_materials = set.has_materials();
  text.add("{}size_{},quantity{}\n", comment_lines(set), name(set.unit), has_materials ? ",material" : "");
  for (const ParticleClass &c : set.classes)
    for (const ParticleSize &size : c.sizes)
      text.add("{},{}{}\n", size.diameter.text, to_string(size.quantity),
               has_materials ? "," + csv_field(c.material) : "");
  text.finish();
}

void write_diameters(const ParticleSet &set, const Sink &out) {
  LongText text(out);
  text.add("{}", comment_lines(set));
  for (auto c = set.classes.rbegin(); c != set.classes.rend(); ++c)
    for (auto size = c->sizes.rbegin(); size != c->sizes.rend(); ++size)
      for (Integer i = 0; i < size->quantity; ++i)
        text.add("{}\n", size->diameter.text);
  text.finish();
}

} // namespace mdm
