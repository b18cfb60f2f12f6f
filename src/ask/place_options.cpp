#include "ask/place_options.hpp"

#include "ask/option_values.hpp"
#include "particles/placed_sink.hpp"

#include <mdm/match/solids.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

SpaceBox from_origin(const Rational &a, const Rational &b, const Rational &c) {
  return {{0, 0, 0}, {a, b, c}};
}

/// `AxB`, which ends at the top of the spheres, or `AxBxC`.
void set_box(const std::string &text, SizeUnit unit, SampleSpace &space) {
  const std::vector<Rational> sides = box_sides("box", text, unit);
  space.to_top = sides.size() == 2;
  space.has_top = !space.to_top;
  space.box = from_origin(sides[0], sides[1], space.to_top ? Rational(1) : sides[2]);
}

/// `cylinder:D`, which ends at the top of the spheres. False for another shape.
bool set_open_cylinder(const std::string &text, SizeUnit unit, SampleSpace &space) {
  constexpr std::string_view begin = "cylinder:";
  if (!text.starts_with(begin) || text.find('x') != std::string::npos)
    return false;
  const Rational diameter = length("specimen", text.substr(begin.size())).in(unit);
  space.is_cylinder = true;
  space.has_top = false;
  space.box = from_origin(diameter, diameter, 1);
  return true;
}

void set_specimen(const std::string &text, SizeUnit unit, SampleSpace &space) {
  if (set_open_cylinder(text, unit, space))
    return;
  const Solids shape =
      named("specimen", text, [unit](const std::string &words) { return parse_specimen(words, "0", unit); });
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
Rational distance(const char *name, const std::string &text, SizeUnit unit) {
  return text == "0" ? Rational(0) : length(name, text).in(unit);
}

} // namespace

const std::vector<OptionRow<PlaceTexts>> PlaceTexts::options = {
    {"packing", "", OptionKind::flag,
     "what the places of the particles say too: void ratio, contacts, overlaps, floating particles, heights "
     "of the classes; for files with x y z, of up to 20000 particles without this; the options below ask "
     "for it too",
     &PlaceTexts::packing},
    {"box", "AxB[xC]", OptionKind::text,
     "the space, from the origin, in the gradation's unit; without a height it ends at the top of the "
     "highest "
     "particle, as the file's box does, which is taken without this",
     &PlaceTexts::box},
    {"specimen", "SHAPE", OptionKind::text,
     "the same as cylinder:DxH, or cylinder:D up to the top of the highest particle, which touches the axes' "
     "planes as that of export does, or box:AxBxC",
     &PlaceTexts::specimen},
    {"periodic", "AXES", OptionKind::text,
     "the axes that are periodic, such as xyz, or none; told by dumps and extended XYZ",
     &PlaceTexts::periodic},
    {"contact-gap", "GAP", OptionKind::number,
     "the gap up to which two particles touch, in the gradation's unit (0)", &PlaceTexts::contact_gap},
    {"margin", "LENGTH", OptionKind::number,
     "what the inner part keeps away from walls, floor and top, in the gradation's unit (two largest "
     "diameters)",
     &PlaceTexts::margin}};

void PlaceTexts::check() const {
  if (box && specimen)
    throw InputError(option("box") + " and " + option("specimen") + " are both the space: give one of them");
}

SampleSpace PlaceTexts::space(const std::optional<ParticleBox> &of_file, SizeUnit unit) const {
  SampleSpace space;
  if (box)
    set_box(*box, unit, space);
  else if (specimen)
    set_specimen(*specimen, unit, space);
  else
    space = space_of_file(of_file);
  if (periodic) {
    space.periodic = {};
    if (*periodic != "none")
      for (const char axis : *periodic) {
        if (axis < 'x' || axis > 'z')
          throw InputError(option("periodic") + ": " + in_quotes(*periodic) +
                           " is neither axes such as xy nor none");
        space.periodic[static_cast<std::size_t>(axis - 'x')] = true;
      }
  }
  return space;
}

SphereTextureOptions PlaceTexts::texture(const std::optional<ParticleBox> &of_file, SizeUnit unit) const {
  SphereTextureOptions asked;
  SampleSpace &space = asked.space;
  space = this->space(of_file, unit);
  const bool is_any = space.periodic[0] || space.periodic[1] || space.periodic[2];
  if (is_any && !space.box)
    throw InputError(option("periodic") + ": the file has no box: give " + option("box") + " too");
  if (is_any && space.is_cylinder)
    throw InputError(option("periodic") + ": a cylinder has walls: leave it out");
  if (space.periodic[2])
    space.to_top = false;
  if (space.periodic[2] && box && std::count(box->begin(), box->end(), 'x') == 1)
    throw InputError(option("periodic") + ": of a box that is periodic in z the height is needed: give " +
                     option("box") + " AxBxC");
  if (contact_gap)
    asked.gap = distance("contact-gap", *contact_gap, unit);
  if (margin)
    asked.margin = distance("margin", *margin, unit);
  return asked;
}

} // namespace mdm
