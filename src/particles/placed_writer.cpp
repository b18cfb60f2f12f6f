#include "particles/particle_writer.hpp"
#include "text/long_text.hpp"

#include <fmt/compile.h>

#include <algorithm>

namespace mdm {
namespace {

/// VTK's title has at most 256 characters, its line end included.
constexpr std::size_t longest_title = 255;

std::string box_line(const Placement &start) {
  const auto &[a, b, height] = start.box();
  const char *const how = start.is_kept() ? "the particles are where they were" : "no two particles overlap";
  if (start.sides() == Sides::cylinder)
    return fmt::format("Cylinder: diameter {}, height {}, in the box of that width from the origin; {}.",
                       start.text(a), start.text(height), how);
  return fmt::format("Box: {} x {} x {}, from the origin{}; {}.", start.text(a), start.text(b),
                     start.text(height), start.repeated_text(), how);
}

/// \param is_typed each class has a type of its own, from 1 on, and there is one more for walls
void write_data(const Placement &start, bool is_typed, const Sink &out) {
  const ParticleSet &set = start.set();
  LongText text(out);
  text.add("{}\n# {}\n# {}\n", title(set), mass_statement(set), box_line(start));
  if (is_typed)
    text.add("# Type {} is of walls; the others are the classes:\n", set.classes.size() + 1);
  for (std::size_t i = 0; is_typed && i < set.classes.size(); ++i)
    text.add("# {} {}\n", i + 1, set.classes[i].text());
  text.add("\n{} atoms\n{} atom types\n\n", to_string(set.particles()),
           is_typed ? set.classes.size() + 1 : 1);
  for (std::size_t axis = 0; axis < 3; ++axis)
    text.add("0 {} {}lo {}hi\n", start.text(start.box()[axis]), "xyz"[axis], "xyz"[axis]);
  text.add("\nAtoms # sphere\n\n");
  std::vector<std::string> densities;
  for (const ParticleClass &c : set.classes)
    densities.push_back(short_decimal(c.density));
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {} {} {} {} {}\n", ++id, is_typed ? s.class_index + 1 : 1, s.size->diameter.text,
             densities[s.class_index], start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]));
  });
  text.finish();
}

} // namespace

void write_lammps_data(const Placement &start, const Sink &out) {
  write_data(start, false, out);
}

void write_lammps_data_of_discs(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  const auto &[width, thickness, height] = start.box();
  LongText text(out);
  text.add("{}\n# Discs in a plane: dimension 2, boundary f f p, fix enforce2d; no two overlap. All are two "
           "thirds of the smallest diameter long.\n"
           "# Densities are those of spheres that have the masses of the discs.\n"
           "\n{} atoms\n1 atom types\n\n0 {} xlo xhi\n0 {} ylo yhi\n-{} {} zlo zhi\n\nAtoms # sphere\n\n",
           title(set), to_string(set.particles()), start.text(width), start.text(height),
           start.text(thickness / 2), start.text(thickness / 2));
  const double smallest = set.smallest().diameter.value;
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    const double density = set.classes[s.class_index].density.convert_to<double>();
    text.add("{} 1 {} {:.17g} {} {} 0\n", ++id, s.size->diameter.text,
             density * smallest / s.size->diameter.value, start.text(s.at[0]), start.text(s.at[2]));
  });
  text.finish();
}

void write_lammps_data_of_classes(const Placement &start, const Sink &out) {
  write_data(start, true, out);
}

void write_xyzr(const Placement &start, const Sink &out) {
  LongText text(out);
  // Without an empty line: YADE's reader takes the first word of every line.
  text.add(
      "#format x_y_z_r\n{}# {}\n# YADE: O.bodies.append(ymport.text('FILE')) with FILE, the name of this "
      "file.\n",
      comment_lines(start.set()), box_line(start));
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {} {}\n", start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]),
             s.size->radius.text);
  });
  text.finish();
}

void write_pfc(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  LongText text(out);
  text.add("EVENT_LABEL,PFC_BALL_LOCX,PFC_BALL_LOCY,PFC_BALL_LOCZ,PFC_BALL_RADIUS,PFC_BALL_ATTR\n");
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    text.add("{},{},{},{},{},{}\n", ++id, start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]),
             s.size->radius.text, set.classes[s.class_index].number);
  });
  text.finish();
}

void write_extxyz(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  const auto &[a, b, height] = start.box();
  LongText text(out);
  std::string heading = title(set) + ". " + mass_statement(set);
  std::replace(heading.begin(), heading.end(), '"', '\'');
  std::replace(heading.begin(), heading.end(), '\\', '/');
  std::string pbc;
  for (const bool is_repeated : start.repeated())
    pbc += std::string(pbc.empty() ? "" : " ") + (is_repeated ? "T" : "F");
  // X is the species of what is no element.
  text.add("{}\nLattice=\"{} 0 0 0 {} 0 0 0 {}\" Properties=species:S:1:type:I:1:pos:R:3:radius:R:1:id:I:1 "
           "pbc=\"{}\" unit={} Title=\"{}\"\n",
           to_string(set.particles()), start.text(a), start.text(b), start.text(height), pbc, name(set.unit),
           heading);
  std::uint64_t id = 0;
  start.each([&](const Placement::Sphere &s) {
    text.add("X {} {} {} {} {} {}\n", set.classes[s.class_index].number, start.text(s.at[0]),
             start.text(s.at[1]), start.text(s.at[2]), s.size->radius.text, ++id);
  });
  text.finish();
}

void write_vtk(const Placement &start, const Sink &out) {
  const ParticleSet &set = start.set();
  const std::string n = to_string(set.particles());
  // Cut in front, so that the statement stays whole; not inside a character.
  std::string heading = title(set) + ". " + mass_statement(set);
  if (heading.size() > longest_title) {
    std::size_t cut = heading.size() - longest_title;
    while ((static_cast<unsigned char>(heading[cut]) & 0xc0U) == 0x80U)
      ++cut;
    heading.erase(0, cut);
  }
  LongText text(out);
  text.add("# vtk DataFile Version 3.0\n{}\nASCII\nDATASET POLYDATA\nPOINTS {} double\n", heading, n);
  start.each([&](const Placement::Sphere &s) {
    text.add("{} {} {}\n", start.text(s.at[0]), start.text(s.at[1]), start.text(s.at[2]));
  });
  text.add("VERTICES {} {}\n", n, to_string(Integer(2 * set.particles())));
  std::uint64_t point = 0;
  start.each([&](const Placement::Sphere &) { text.add("1 {}\n", point++); });
  text.add("POINT_DATA {}\nSCALARS radius double 1\nLOOKUP_TABLE default\n", n);
  start.each([&](const Placement::Sphere &s) { text.add("{}\n", s.size->radius.text); });
  text.add("SCALARS class int 1\nLOOKUP_TABLE default\n");
  start.each([&](const Placement::Sphere &s) { text.add("{}\n", set.classes[s.class_index].number); });
  text.finish();
}

} // namespace mdm
