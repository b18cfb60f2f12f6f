#include "report/sphere_report.hpp"

#include "report/interval_json.hpp"
#include "text/option_name.hpp"
#include "text/text_buffer.hpp"
#include "text/text_table.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/format.h>

namespace mdm {
namespace {

constexpr unsigned shown_digits = 6;

std::string of_axes(const std::array<bool, 3> &axes) {
  std::string names;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (axes[axis])
      names += "xyz"[axis];
  return names;
}

std::string box_text(const SpaceBox &box) {
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis)
    text += (axis == 0 ? "" : " x ") + ("[" + approximate(box.low[axis], shown_digits)) + ", " +
            approximate(box.high[axis], shown_digits) + "]";
  return text;
}

std::string coordination_text(const SphereCoordination &c) {
  if (c.spheres == 0)
    return "no particle has its centre there";
  const std::optional<Rational> others = c.mean_without_rattlers();
  return fmt::format("{}; {} without {} rattler{}, {} of them floating", approximate(c.mean(), shown_digits),
                     others ? approximate(*others, shown_digits) : "none", c.rattlers,
                     c.rattlers == 1 ? "" : "s", c.floating);
}

std::string share_text(const Interval &y) {
  constexpr unsigned digits = 3;
  return approximate(Rational(50 * (y.lo + y.hi)), digits);
}

void write_box(JsonWriter &json, const SpaceBox &box) {
  json.begin_object();
  for (const bool is_low : {true, false}) {
    json.key(is_low ? "low" : "high").begin_array();
    for (const Rational &x : is_low ? box.low : box.high)
      write(json, x);
    json.end_array();
  }
  json.end_object();
}

void write_coordination(JsonWriter &json, const SphereCoordination &c) {
  json.begin_object().key("particles").number(c.spheres);
  json.key("mean");
  if (c.spheres == 0)
    json.null();
  else
    write(json, c.mean());
  write(json.key("without_rattlers"), c.mean_without_rattlers());
  json.key("rattlers").number(c.rattlers).key("floating").number(c.floating).end_object();
}

void write_or_null(JsonWriter &json, const std::optional<Interval> &y) {
  if (y)
    write_number(json, *y);
  else
    json.null();
}

} // namespace

std::string sphere_texture_text(const SphereTexture &t, const Gradation &g) {
  TextBuffer out;
  const std::string_view unit = name(g.unit());
  const std::string periodic = of_axes(t.periodic);
  add(out, "\n  packing, lengths in {}\n", unit);
  add(out, "    space: {}{}{}\n", t.is_cylinder ? "the cylinder in " : "", box_text(t.space),
      periodic.empty() ? "" : ", periodic in " + periodic);
  if (t.outside > 0)
    add(out, "    centres outside it: {}\n", t.outside);
  add(out, "    void ratio: {}\n", interval_text(t.void_ratio));
  if (t.inner)
    add(out, "    void ratio of the inner part {}: {}\n", box_text(*t.inner),
        t.inner_void_ratio ? interval_text(*t.inner_void_ratio) : "nothing is in it");
  else
    add(out, "    void ratio of the inner part: there is none, the margin leaves too little\n");
  add(out, "    contacts of two particles{}: {}\n",
      t.gap == 0 ? "" : ", with a gap up to " + approximate(t.gap, shown_digits), t.contacts);
  if (t.contacts == 0 && t.coordination.spheres > 1)
    add(out,
        "    where digits of places or sizes were cut, spheres that touch have a gap: {} GAP takes gaps up "
        "to GAP as contacts\n",
        option("contact-gap"));
  add(out, "    coordination: {}\n", coordination_text(t.coordination));
  if (t.inner)
    add(out, "    coordination of the inner part: {}\n", coordination_text(t.inner_coordination));
  if (t.overlaps.pairs == 0)
    add(out, "    overlaps: none\n");
  else
    add(out, "    overlaps: {}, the largest {} ({} % of the smaller diameter), on average {}\n",
        t.overlaps.pairs, interval_text(t.overlaps.largest),
        interval_text(Interval(Rational(100)) * t.overlaps.largest_relative), interval_text(t.overlaps.mean));
  if (t.segregation)
    add(out, "    segregation by height (Danckwerts; 0 none, 1 full): {}\n", interval_text(*t.segregation));
  add(out, "\n  volume % of the particles whose centres are in ten bands of equal height, from below\n\n");
  std::vector<std::vector<std::string>> lines = {{"class", "mean height"}};
  for (std::size_t k = 1; k < t.band_heights.size(); ++k)
    lines.front().push_back(std::to_string(k));
  for (std::size_t j = 0; j < t.groups.size(); ++j) {
    const SphereGroup &group = t.groups[j];
    if (!group.mean_height)
      continue;
    std::vector<std::string> line = {std::to_string(j + 1), interval_text(*group.mean_height)};
    for (const Interval &share : group.shares)
      line.push_back(share_text(share));
    lines.push_back(std::move(line));
  }
  add(out, "{}", text_table(lines, std::string(t.band_heights.size() + 1, '>')));
  return fmt::to_string(out);
}

void write_sphere_texture(JsonWriter &json, const SphereTexture &t, const Gradation &g) {
  json.begin_object()
      .key("unit")
      .plain(name(g.unit()))
      .key("shape")
      .plain(t.is_cylinder ? "cylinder" : "box");
  write_box(json.key("space"), t.space);
  json.key("periodic").plain(of_axes(t.periodic)).key("outside").number(t.outside);
  write_number(json.key("void_ratio"), t.void_ratio);
  json.key("inner");
  if (t.inner) {
    write_box(json.begin_object().key("space"), *t.inner);
    write_or_null(json.key("void_ratio"), t.inner_void_ratio);
    write_coordination(json.key("coordination"), t.inner_coordination);
    json.end_object();
  } else {
    json.null();
  }
  write(json.key("gap"), t.gap);
  json.key("contacts").number(t.contacts);
  write_coordination(json.key("coordination"), t.coordination);
  json.key("overlaps").begin_object().key("pairs").number(t.overlaps.pairs);
  write_number(json.key("largest"), t.overlaps.largest);
  write_number(json.key("largest_relative"), t.overlaps.largest_relative);
  write_number(json.key("mean"), t.overlaps.mean);
  json.end_object().key("band_heights").begin_array();
  for (const Rational &height : t.band_heights)
    write(json, height);
  json.end_array().key("classes").begin_array();
  for (const SphereGroup &group : t.groups) {
    json.begin_object().key("particles").number(group.spheres);
    write_or_null(json.key("mean_height"), group.mean_height);
    json.key("shares").begin_array();
    for (const Interval &share : group.shares)
      write_number(json, share);
    json.end_array().end_object();
  }
  json.end_array();
  write_or_null(json.key("segregation"), t.segregation);
  json.end_object();
}

} // namespace mdm
