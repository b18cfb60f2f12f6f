#include "packing/texture.hpp"

namespace mdm {
namespace {

constexpr unsigned bands = 10;

bool is_inside(const PackedDisc &d, const PackingWindow &w) {
  return d.x >= w.x_min && d.x <= w.x_max && d.y >= w.y_min && d.y <= w.y_max;
}

std::vector<HeightBand> height_bands(const Packing &p, const PackingWindow &w) {
  std::vector<HeightBand> all(bands);
  std::vector<Integer> squares(bands), cubes(bands);
  const Integer height = w.y_max - w.y_min;
  for (unsigned i = 0; i < bands; ++i) {
    all[i].from = Rational(w.y_min) + ratio(height * i, bands);
    all[i].to = Rational(w.y_min) + ratio(height * (i + 1), bands);
  }
  for (const PackedDisc &d : p.discs) {
    if (!is_inside(d, w) || d.y == w.y_max)
      continue;
    const auto i = static_cast<std::size_t>(floor_div(Integer(d.y - w.y_min) * bands, height));
    ++all[i].discs;
    squares[i] += Integer(d.r) * d.r;
    cubes[i] += Integer(d.r) * d.r * d.r;
  }
  for (unsigned i = 0; i < bands; ++i)
    if (all[i].discs > 0)
      all[i].mean_diameter = ratio(2 * cubes[i], squares[i]);
  return all;
}

CellCounts cell_counts(const Packing &p, const PackingContacts &contacts) {
  CellCounts n;
  each_cell(p, contacts, [&n](const std::vector<CellCorner> &corners) {
    constexpr std::size_t pentagon = 5;
    ++(corners.size() == 3          ? n.triangles
       : corners.size() == 4        ? n.quadrangles
       : corners.size() == pentagon ? n.pentagons
                                    : n.larger);
  });
  return n;
}

} // namespace

Rational mean_coordination(const Coordination &coordination) {
  Integer contacts = 0, discs = 0;
  for (const auto &[n, count] : coordination) {
    contacts += Integer(n) * count;
    discs += count;
  }
  return ratio(contacts, discs);
}

PackingTexture packing_texture(const Packing &p) {
  PackingTexture t;
  t.window = p.inner_window();
  t.contacts = packing_contacts(p);
  for (std::size_t i = 0; i < p.discs.size(); ++i) {
    ++t.coordination[t.contacts.of_disc[i]];
    if (!t.window.is_empty() && is_inside(p.discs[i], t.window))
      ++t.inner_coordination[t.contacts.of_disc[i]];
  }
  t.cells = cell_counts(p, t.contacts);
  if (!t.window.is_empty()) {
    t.fraction = packing_fraction(p, t.window);
    t.bands = height_bands(p, t.window);
  }
  return t;
}

} // namespace mdm
