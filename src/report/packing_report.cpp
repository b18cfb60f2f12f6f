#include "report/packing_report.hpp"

#include "answer/json_values.hpp"
#include "packing/packing_writer.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

constexpr unsigned exact_digits = 15;
/// For people.
constexpr unsigned short_digits = 6;

/// A multiple of a thousandth of the packing's unit, as gaps are.
std::string gap_text(const Packing &p, const Rational &units) {
  constexpr unsigned more_places = 3;
  return decimal_string(floor(Rational(units * Rational(power_of_ten(more_places)))), p.places + more_places);
}

/// A length in units of the lattice, in the packing's unit.
Real length(const Packing &p, const Rational &units) {
  return Real(Rational(units / Rational(power_of_ten(p.places))));
}

std::string with_unit(const Packing &p, const std::string &length) {
  return length + (p.unit.empty() ? "" : " " + p.unit);
}

/// The ends of what is known; empty texts where nothing is.
std::pair<std::string, std::string> ends(const Packing &p, const std::optional<Interval> &gap) {
  if (!gap)
    return {};
  return {gap_text(p, gap->lo), gap_text(p, gap->hi)};
}

std::pair<std::string, std::string> ends(const std::optional<Real> &fraction) {
  if (!fraction)
    return {};
  const Enclosure e = enclose(*fraction, exact_digits);
  return {e.lower_text(), e.upper_text()};
}

void write_ends(JsonWriter &json, const std::pair<std::string, std::string> &ends) {
  if (ends.first.empty())
    json.null();
  else
    json.bounds(ends.first, ends.second);
}

void write_coordination(JsonWriter &json, const Coordination &coordination) {
  if (coordination.empty()) {
    json.null();
    return;
  }
  write(json.begin_object().key("mean"), mean_coordination(coordination)).key("discs").begin_array();
  for (const auto &[contacts, discs] : coordination)
    json.begin_object().key("contacts").number(contacts).key("discs").number(discs).end_object();
  json.end_array().end_object();
}

void write_bands(JsonWriter &json, const Packing &p, const std::vector<HeightBand> &bands) {
  json.begin_array();
  for (const HeightBand &b : bands) {
    write(json.begin_object().key("from"), enclose(length(p, b.from), exact_digits));
    write(json.key("to"), enclose(length(p, b.to), exact_digits));
    json.key("discs").number(b.discs).key("mean_diameter");
    if (b.discs == 0)
      json.null();
    else
      write(json, enclose(length(p, b.mean_diameter), exact_digits));
    json.end_object();
  }
  json.end_array();
}

void write_window(JsonWriter &json, const Packing &p, const PackingWindow &w) {
  if (w.is_empty()) {
    json.null();
    return;
  }
  json.begin_object().key("x").bounds(p.text(w.x_min), p.text(w.x_max));
  json.key("y").bounds(p.text(w.y_min), p.text(w.y_max)).end_object();
}

void write_contacts(JsonWriter &json, const Packing &p, const PackingContacts &c) {
  json.begin_object().key("tolerance").plain(p.text(c.tolerance)).key("of_discs").number(c.pairs.size());
  json.key("with_floor").number(c.on_floor).key("with_walls").number(c.on_walls);
  write_ends(json.key("largest_gap"), ends(p, c.largest_gap));
  write_ends(json.key("smallest_other_gap"), ends(p, c.smallest_other_gap));
  json.key("overlaps").number(c.overlaps).end_object();
}

void write_positions(JsonWriter &json, const Packing &p) {
  json.begin_array();
  for (const PackedDisc &d : p.discs)
    json.begin_array().plain(p.text(d.x)).plain(p.text(d.y)).plain(p.text(d.r)).end_array();
  json.end_array();
}

void write_judgement(JsonWriter &json, const PackingJudgement &j) {
  json.begin_object().key("sizes").string(j.sizes).key("packing").string(j.packing);
  json.key("verdict").plain(j.is_accepted() ? "accepted" : "refused");
  json.key("objections").strings(j.objections).key("not_verified").strings(j.unverified).end_object();
}

std::string coordination_table(const PackingTexture &t) {
  TextTable table;
  table.add_column("contacts", '>');
  table.add_column("discs", '>');
  table.add_column("in the window", '>');
  for (const auto &[contacts, discs] : t.coordination) {
    const auto inner = t.inner_coordination.find(contacts);
    table.add_line();
    table.add(std::to_string(contacts));
    table.add(std::to_string(discs));
    table.add(inner == t.inner_coordination.end() ? "0" : std::to_string(inner->second));
  }
  return table.text();
}

std::string mean_text(const Coordination &c) {
  return c.empty() ? "none" : rounded(Real(mean_coordination(c)), short_digits);
}

} // namespace

std::string packing_judgement_text(const PackingJudgement &j) {
  const std::string name = printable(j.packing);
  std::string text =
      j.is_accepted()
          ? fmt::format(
                "{}: accepted: a packing of the set's discs (not verified: that they came there by {})\n",
                name, fmt::join(j.unverified, ", "))
          : "";
  for (const std::string &objection : j.objections)
    text += name + ": refused: " + objection + "\n";
  return text;
}

std::string packing_text(const Packing &p, const PackingTexture &t) {
  const PackingContacts &c = t.contacts;
  std::string text = fmt::format("{} discs, rule {}, floor {}, seed {}\nbox {} wide, {}\n", p.discs.size(),
                                 name(p.rule), name(p.floor), p.seed, with_unit(p, p.text(p.width)),
                                 p.periodic ? "periodic" : "between walls");
  if (t.fraction)
    text += fmt::format("packing fraction {} from {} to {} above the floor{}\n",
                        enclose(*t.fraction, exact_digits).text(), p.text(t.window.y_min),
                        with_unit(p, p.text(t.window.y_max)),
                        p.periodic ? "" : ", " + with_unit(p, p.text(t.window.x_min)) + " from the walls");
  else
    text += "too low for a packing fraction: less than three of the largest discs above the floor\n";
  if (c.first_overlap)
    text += fmt::format("{} pairs of discs overlap, first {} and {}\n", c.overlaps, c.first_overlap->first,
                        c.first_overlap->second);
  else
    text += "no two discs overlap\n";
  text += fmt::format("{} contacts of two discs, {} with the floor, {} with walls (gaps up to {})\n",
                      c.pairs.size(), c.on_floor, c.on_walls, with_unit(p, p.text(c.tolerance)));
  if (c.largest_gap)
    text += fmt::format("largest gap of a contact: {}\n", with_unit(p, gap_text(p, c.largest_gap->hi)));
  if (c.smallest_other_gap)
    text +=
        fmt::format("smallest gap of other discs: {}\n", with_unit(p, gap_text(p, c.smallest_other_gap->lo)));
  text += fmt::format("coordination: mean {}, in the window {}\n\n", mean_text(t.coordination),
                      mean_text(t.inner_coordination)) +
          coordination_table(t);
  text += fmt::format("\ncells of the contact graph: {} triangles, {} quadrangles, {} pentagons, {} larger\n",
                      t.cells.triangles, t.cells.quadrangles, t.cells.pentagons, t.cells.larger);
  if (!t.bands.empty()) {
    text += "mean diameter by area, in ten bands of height from below:";
    for (const HeightBand &b : t.bands)
      text += b.discs == 0 ? " none" : " " + rounded(length(p, b.mean_diameter), short_digits);
    text += "\n";
  }
  return text;
}

void packing_json(const Packing &p, const PackingTexture &t, const PackingJsonParts &parts,
                  const Sink &sink) {
  JsonWriter json(sink);
  json.begin_object().key("schema").plain("mdm-packing-1");
  if (parts.judgement != nullptr)
    write_judgement(json.key("judgement"), *parts.judgement);
  write_text(json.key("unit"), p.unit).key("discs").number(p.discs.size());
  json.key("width").plain(p.text(p.width)).key("sides").plain(p.periodic ? "periodic" : "walls");
  json.key("rule").plain(name(p.rule)).key("floor").plain(name(p.floor)).key("seed").number(p.seed);
  json.key("radii").plain(p.radii_hash());
  write_window(json.key("window"), p, t.window);
  write_ends(json.key("packing_fraction"), ends(t.fraction));
  write_contacts(json.key("contacts"), p, t.contacts);
  write_coordination(json.key("coordination").begin_object().key("all"), t.coordination);
  write_coordination(json.key("window"), t.inner_coordination);
  json.end_object().key("cells").begin_object().key("triangles").number(t.cells.triangles);
  json.key("quadrangles").number(t.cells.quadrangles).key("pentagons").number(t.cells.pentagons);
  json.key("larger").number(t.cells.larger).end_object();
  write_bands(json.key("bands"), p, t.bands);
  if (parts.positions)
    write_positions(json.key("positions"), p);
  json.key("versions").raw(versions_json()).end_object().hand_on();
}

std::string packing_csv(const Packing &p, const PackingTexture &t) {
  const auto [fraction_lo, fraction_hi] = ends(t.fraction);
  const auto [largest_lo, largest_hi] = ends(p, t.contacts.largest_gap);
  const auto [other_lo, other_hi] = ends(p, t.contacts.smallest_other_gap);
  constexpr std::uint32_t columns = 7;
  std::string names =
      "discs,packing_fraction_lo,packing_fraction_hi,contacts,floor_contacts,wall_contacts,overlaps,"
      "largest_gap_lo,largest_gap_hi,smallest_other_gap_lo,smallest_other_gap_hi,triangles,"
      "quadrangles,pentagons,larger_cells";
  std::string values =
      fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}", p.discs.size(), fraction_lo, fraction_hi,
                  t.contacts.pairs.size(), t.contacts.on_floor, t.contacts.on_walls, t.contacts.overlaps,
                  largest_lo, largest_hi, other_lo, other_hi, t.cells.triangles, t.cells.quadrangles,
                  t.cells.pentagons, t.cells.larger);
  for (std::uint32_t n = 0; n <= columns; ++n) {
    std::uint64_t discs = 0;
    for (const auto &[contacts, count] : t.coordination)
      discs += contacts == n || (n == columns && contacts > n) ? count : 0;
    names += fmt::format(",touching_{}{}", n, n == columns ? "_or_more" : "");
    values += fmt::format(",{}", discs);
  }
  return names + "\n" + values + "\n";
}

} // namespace mdm
