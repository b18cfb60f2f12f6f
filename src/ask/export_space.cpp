#include "ask/export_space.hpp"

#include "ask/option_values.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <array>
#include <cmath>

namespace mdm {
namespace {

Footprint footprint_of(const std::string &text, SizeUnit unit) {
  const std::vector<Rational> lengths = box_sides("box", text, unit);
  return {lengths[0], lengths[1], lengths.size() == 3 ? std::optional(lengths[2]) : std::nullopt};
}

/// The ground in the unit of the gradation, or of the answer; open: none was asked for.
std::optional<Footprint> asked_ground(const ExportTexts &c, SizeUnit unit) {
  if (c.box)
    return footprint_of(*c.box, unit);
  const std::optional<Solids> shape = asked_specimen(c, unit);
  if (!shape)
    return std::nullopt;
  if (const Box *const box = std::get_if<Box>(&*shape))
    return Footprint{box->a, box->b, std::nullopt};
  const Rational &diameter = std::get<Cylinder>(*shape).diameter;
  return asked_space(c) == Space::cylinder ? Footprint{diameter, diameter, std::nullopt}
                                           : inscribed_square(diameter);
}

/// The plane of discs: --box has its width and its height.
Footprint plane_of_discs(const ExportTexts &c, const ExportedParticles &found) {
  if (!c.box)
    return disc_plane(*found.set);
  const Footprint box = footprint_of(*c.box, found.unit);
  if (box.c)
    throw InputError(option("box") + ": discs have a width and a height: write AxB");
  const Rational unit = in_mm(found.unit) / in_mm(found.set->unit);
  return disc_plane(*found.set, box.a * unit, Rational(box.b * unit));
}

/// The ratios of the sides of a box whose faces move.
std::array<Rational, 3> cell_ratios(const ExportTexts &c) {
  if (c.box) {
    const Footprint box = footprint_of(*c.box, SizeUnit::mm);
    if (!box.c)
      throw InputError(option("box") +
                       ": a box whose faces move has three sides, of which the ratios count: write AxBxC");
    return {box.a, box.b, *box.c};
  }
  const std::optional<Solids> shape = asked_specimen(c, SizeUnit::mm);
  if (!shape)
    return {1, 1, 1};
  const Box &box = std::get<Box>(*shape);
  return {box.a, box.b, box.c};
}

Sides sides_of(Space space) {
  return space == Space::cylinder ? Sides::cylinder : space == Space::pillar ? Sides::periodic : Sides::walls;
}

/// Above this number, particles are mixed by request alone: it takes seconds and memory.
constexpr std::uint64_t most_mixed = 1000000;

/// True if a deposit has room on the ground.
bool has_room_for_deposit(const ParticleSet &set, const std::optional<Footprint> &ground) {
  if (set.particles() > most_deposited)
    return false;
  const Rational least = (least_widths + ratio(1, 1000)) * set.largest().diameter.decimal();
  return !ground || std::min(ground->a, ground->b) >= least;
}

/// The densest start that serves where a density is asked for; else the quickest that mixes the sizes.
Start start_of_model(const ExportTexts &c, const ExportedParticles &found) {
  const bool has_target = c.solve.void_ratio || c.pressure;
  const bool is_many = found.set->particles() > most_mixed;
  if (c.moves_faces() || c.has_discs())
    return Start::mixed;
  if ((has_target || (is_many && asked_space(c) == Space::cylinder)) &&
      has_room_for_deposit(*found.set, footprint(c, found)))
    return Start::deposit;
  return is_many && asked_space(c) == Space::box ? Start::layers : Start::mixed;
}

} // namespace

std::optional<Solids> asked_specimen(const ExportTexts &c, SizeUnit unit) {
  if (c.box || !c.solve.specimen)
    return std::nullopt;
  return named("specimen", *c.solve.specimen, [&c, unit](const std::string &text) {
    return parse_specimen(text, c.solve.void_ratio.value_or("0"), unit);
  });
}

Space asked_space(const ExportTexts &c) {
  if (c.has_discs())
    return Space::plane;
  if (c.has_six_walls())
    return Space::six_walls;
  if (c.has_cell())
    return Space::periodic_cell;
  if (c.sides)
    return *c.sides == "cylinder" ? Space::cylinder : *c.sides == "periodic" ? Space::pillar : Space::box;
  const std::optional<Solids> shape = asked_specimen(c, SizeUnit::mm);
  const bool has_round_start = c.model ? c.start != "layers" : c.start == "deposit" || c.start == "mixed";
  return has_round_start && shape && std::holds_alternative<Cylinder>(*shape) ? Space::cylinder : Space::box;
}

std::optional<Footprint> footprint(const ExportTexts &c, const ExportedParticles &found) {
  if (c.has_discs())
    return plane_of_discs(c, found);
  if (c.moves_faces())
    return roomy_box(*found.set, cell_ratios(c));
  std::optional<Footprint> floor = asked_ground(c, found.unit);
  if (!floor) {
    if (asked_space(c) == Space::box)
      return floor;
    floor = deposit_square(*found.set);
    floor->sides = sides_of(asked_space(c));
    return floor;
  }
  if (asked_space(c) == Space::cylinder && floor->a != floor->b)
    throw InputError(option("sides") + " cylinder: its box is as long as wide: give " + option("box") +
                     " its diameter twice");
  floor->sides = sides_of(asked_space(c));
  const Rational unit = in_mm(found.unit) / in_mm(found.set->unit);
  floor->a *= unit;
  floor->b *= unit;
  if (floor->c)
    *floor->c *= unit;
  return floor;
}

namespace {

/// True if the places of the file have the space that is asked for.
bool keeps_places(const ExportTexts &c, const ExportedParticles &found) {
  if (!found.places || c.box || c.solve.specimen || c.has_discs())
    return false;
  return !c.has_cell() || found.places->periodic == std::array<bool, 3>{true, true, true};
}

Placement kept(const ExportTexts &c, const ExportedParticles &found) {
  const KeptPlaces &places = *found.places;
  if (c.has_cell() && !keeps_places(c, found))
    throw InputError(option("start") +
                     " as-is: the file has no box that is repeated on all sides, as this "
                     "model's: take " +
                     option("start") + " mixed");
  const bool is_cell = places.periodic == std::array<bool, 3>{true, true, true};
  const bool is_pillar = places.periodic == std::array<bool, 3>{true, true, false};
  if (c.has_six_walls() && (is_cell || is_pillar))
    throw InputError("FILE's box is repeated, and this model's has six walls: give " + option("start") +
                     " mixed");
  if (c.model && ((is_cell && !c.has_cell()) || (is_pillar && asked_space(c) != Space::pillar)))
    throw InputError(fmt::format("FILE's box is repeated: give {} too, or {} mixed",
                                 is_cell ? option("periodic") : option("sides") + " periodic",
                                 option("start")));
  if (asked_space(c) == Space::cylinder && std::abs(places.box[0] - places.box[1]) > 1e-9 * places.box[0])
    throw InputError(option("sides") + " cylinder: the file's box is not as long as wide: leave it out");
  const bool is_as_there = asked_space(c) == Space::box && !c.sides && !c.model;
  const Sides sides = is_as_there && is_pillar ? Sides::periodic : sides_of(asked_space(c));
  return {*found.set, places, sides, is_as_there};
}

} // namespace

Start start_of(const ExportTexts &c, const ExportedParticles &found) {
  if (!c.start && keeps_places(c, found))
    return Start::as_is;
  if (!c.start)
    return c.model ? start_of_model(c, found) : Start::layers;
  if (*c.start == "as-is") {
    if (!found.places)
      throw InputError(option("start") +
                       " as-is: FILE has no place of each particle: take layers, mixed or deposit");
    return Start::as_is;
  }
  if (*c.start == "deposit")
    return Start::deposit;
  return *c.start == "mixed" ? Start::mixed : Start::layers;
}

Placement placed(const ExportTexts &c, const ExportedParticles &found,
                 const std::function<void(std::size_t)> &lying) {
  const Start start = start_of(c, found);
  if (start == Start::as_is)
    return kept(c, found);
  return {*found.set, footprint(c, found), export_seed(c), start, lying};
}

std::vector<std::string> rounding_notes(const ExportTexts &c, const ExportedParticles &found,
                                        const Placement &start) {
  std::vector<std::string> notes;
  if (c.to == "gsd" && start.repeated() != std::array<bool, 3>{true, true, true})
    notes.push_back(
        "GSD has no walls: who reads the file takes its box as one that is repeated on all sides");
  if (start.is_kept()) {
    notes.push_back("the particles stay where they lie in FILE, from the lower corner of " +
                    std::string(found.places->has_box ? "its box" : "the smallest box around them") +
                    " on; " + option("start") + " mixed draws new places");
    return notes;
  }
  if (found.places)
    notes.push_back("the places in FILE are left out; " + option("start") + " as-is keeps them, in its box");
  if (c.model && !c.start && (c.solve.void_ratio || c.pressure) && !c.moves_faces() &&
      start_of(c, found) != Start::deposit)
    notes.push_back(
        fmt::format("the grains start mixed, not as a deposit: the specimen is narrower than {} of the "
                    "largest, or they are too many",
                    least_widths));
  const std::optional<Footprint> asked = footprint(c, found);
  const std::optional<Solids> shape = asked_specimen(c, SizeUnit::mm);
  if (shape && std::holds_alternative<Cylinder>(*shape) && asked_space(c) == Space::box)
    notes.push_back("layers stand on the square inside the cylinder; " + option("start") +
                    " mixed or deposit fills it");
  const bool is_exact = !c.moves_faces() && (c.box || (shape && std::holds_alternative<Box>(*shape)));
  if (!asked || !is_exact || c.has_discs())
    return notes;
  const auto add_side = [&](const Rational &side, std::int64_t units) {
    if (side * power_of_ten(start.places()) != Rational(units))
      notes.push_back(fmt::format("the box's side of {} {} was rounded down to {}", approximate(side, 17),
                                  name(found.set->unit), start.text(units)));
  };
  add_side(asked->a, start.box()[0]);
  add_side(asked->b, start.box()[1]);
  if (asked->c)
    add_side(*asked->c, start.box()[2]);
  return notes;
}

} // namespace mdm
