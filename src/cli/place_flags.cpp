#include "cli/place_flags.hpp"

#include "cli/option_values.hpp"

#include <mdm/match/solids.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm::cli {
namespace {

SpaceBox from_origin(const Rational &a, const Rational &b, const Rational &c) {
  return {{0, 0, 0}, {a, b, c}};
}

/// `AxB`, which ends at the top of the spheres, or `AxBxC`.
void set_box(const std::string &text, SizeUnit unit, SampleSpace &space) {
  const std::vector<Rational> sides = box_sides("--box", text, unit);
  space.to_top = sides.size() == 2;
  space.box = from_origin(sides[0], sides[1], space.to_top ? Rational(1) : sides[2]);
}

void set_specimen(const std::string &text, SizeUnit unit, SampleSpace &space) {
  const Solids shape = named("--specimen", text,
                             [unit](const std::string &words) { return parse_specimen(words, "0", unit); });
  space.to_top = false;
  if (const Box *const box = std::get_if<Box>(&shape)) {
    space.box = from_origin(box->a, box->b, box->c);
    return;
  }
  const auto &cylinder = std::get<Cylinder>(shape);
  space.is_cylinder = true;
  space.box = from_origin(cylinder.diameter, cylinder.diameter, cylinder.height);
}

/// A length from 0 on.
Rational distance(const char *option, const std::string &text, SizeUnit unit) {
  return text == "0" ? Rational(0) : length(option, text).in(unit);
}

} // namespace

void PlaceFlags::add_to(CLI::App &command) {
  command.add_flag(
      "--packing", packing,
      "what the places of the particles say too: void ratio, contacts, overlaps, floating "
      "particles, heights of the classes; for files with x y z, of up to 20000 particles without "
      "this");
  command
      .add_option("--box", box,
                  "with --packing: the space, from the origin, in the gradation's unit; without a height it "
                  "ends at the top of the highest particle, as the file's box does, which is taken without "
                  "this")
      ->type_name("AxB[xC]");
  command
      .add_option("--specimen", specimen,
                  "the same as cylinder:DxH, which touches the axes' planes as that of export does, or "
                  "box:AxBxC")
      ->type_name("SHAPE");
  command
      .add_option("--periodic", periodic,
                  "with --packing: the axes that are periodic, such as xyz, or none; told by dumps and "
                  "extended XYZ")
      ->type_name("AXES");
  command
      .add_option("--contact-gap", gap,
                  "with --packing: the gap up to which two particles touch, in the gradation's unit (0)")
      ->type_name("GAP");
  command
      .add_option("--margin", margin,
                  "with --packing: what the inner part keeps away from walls, floor and top, in the "
                  "gradation's unit (two largest diameters)")
      ->type_name("LENGTH");
}

void PlaceFlags::check() const {
  const auto check_one = [this](const char *option, const GradationFlags::Text &value) {
    if (value && !packing)
      throw InputError(std::string(option) + ": it is about places: give --packing too");
  };
  check_one("--box", box);
  check_one("--specimen", specimen);
  check_one("--periodic", periodic);
  check_one("--contact-gap", gap);
  check_one("--margin", margin);
  if (box && specimen)
    throw InputError("--box and --specimen are both the space: give one of them");
}

SphereTextureOptions PlaceFlags::options(const std::optional<ParticleBox> &of_file, SizeUnit unit) const {
  SphereTextureOptions options;
  SampleSpace &space = options.space;
  if (box)
    set_box(*box, unit, space);
  else if (specimen)
    set_specimen(*specimen, unit, space);
  else if (of_file) {
    space.box = of_file->sides;
    space.periodic = of_file->periodic;
  }
  if (periodic) {
    space.periodic = {};
    if (*periodic != "none")
      for (const char axis : *periodic) {
        if (axis < 'x' || axis > 'z')
          throw InputError("--periodic: " + in_quotes(*periodic) + " is neither axes such as xy nor none");
        space.periodic[static_cast<std::size_t>(axis - 'x')] = true;
      }
  }
  const bool is_any = space.periodic[0] || space.periodic[1] || space.periodic[2];
  if (is_any && !space.box)
    throw InputError("--periodic: the file has no box: give --box too");
  if (is_any && space.is_cylinder)
    throw InputError("--periodic: a cylinder has walls: leave it out");
  if (space.periodic[2])
    space.to_top = false;
  if (space.periodic[2] && box && std::count(box->begin(), box->end(), 'x') == 1)
    throw InputError("--periodic: of a box that is periodic in z the height is needed: give --box AxBxC");
  if (gap)
    options.gap = distance("--contact-gap", *gap, unit);
  if (margin)
    options.margin = distance("--margin", *margin, unit);
  return options;
}

} // namespace mdm::cli
