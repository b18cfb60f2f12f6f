#include "plot/texture_figure.hpp"

#include "plot/figure_layout.hpp"
#include "plot/palette.hpp"
#include "soil/texture_diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace mdm {
namespace {

const double triangle_height = std::sqrt(0.75); // of a triangle with the side 1
constexpr const char *outline_color = "#000000";
constexpr const char *field_color = "#7f8c8d";
constexpr const char *scale_color = "#e4e4e4";

Point point_of(const TexturePlace &p) {
  const double whole = p[0] + p[1] + p[2];
  return {(p[1] + p[2] / 2) / whole, triangle_height * p[2] / whole};
}

Series line_of(const std::vector<TexturePlace> &places, const char *color, double width) {
  Series s;
  s.color = color;
  s.width = width;
  for (const TexturePlace &place : places)
    s.points.push_back(point_of(place));
  return s;
}

/// The place where part i is `percent`, and the part `rest` all else.
TexturePlace on_edge(std::size_t i, std::size_t rest, double percent) {
  TexturePlace place{};
  place.at(i) = percent;
  place.at(rest) = 100 - percent;
  return place;
}

/// How the scale of a part is written beside its edge, on which the part `rest` takes its place.
struct EdgeScale {
  std::size_t part, rest;
  Align align;
  double dx, dy;             ///< of numbers, in pt
  double title_dx, title_dy; ///< of the name at the middle
};
constexpr std::array<EdgeScale, 3> edges = {{{0, 1, Align::center, 0, -10, 0, -28},
                                             {1, 2, Align::left, 6, 2, 32, 8},
                                             {2, 0, Align::right, -6, 2, -32, 8}}};

/// Lines at each fifth of the parts, with their percents and the parts' names beside the edges.
void add_scales(Panel &panel, const std::array<std::string, 3> &names) {
  for (const EdgeScale &edge : edges) {
    const std::size_t third = 3 - edge.part - edge.rest;
    for (int percent = 20; percent < 100; percent += 20) {
      panel.series.push_back(line_of(
          {on_edge(edge.part, edge.rest, percent), on_edge(edge.part, third, percent)}, scale_color, 0.5));
      const Point at = point_of(on_edge(edge.part, edge.rest, percent));
      panel.texts.push_back({at.x, at.y, std::to_string(percent), edge.align, edge.dx, edge.dy});
    }
    const Point middle = point_of(on_edge(edge.part, edge.rest, 50));
    panel.texts.push_back({middle.x, middle.y, fmt::format("{} (%)", names.at(edge.part)), edge.align,
                           edge.title_dx, edge.title_dy});
  }
}

/// Fields on the base itself have their labels below it.
Text label_of(const TextureField &field) {
  const Point at = point_of(field.at);
  constexpr double below_numbers = -10;
  return {at.x, at.y, std::string(field.label), Align::center, 0, field.at[2] > 0 ? 0 : below_numbers};
}

/// What short labels are short for, a line each.
std::vector<std::string> short_labels(const TextureDiagram &diagram) {
  std::vector<std::string> all;
  for (const TextureField &field : diagram.fields)
    if (field.label != field.name)
      all.push_back(fmt::format("{}: {}", field.label, field.name));
  return all;
}

/// \pre the curve has a texture
Series mark_of(TextureSystem system, const GradingCurve &curve, std::size_t number) {
  constexpr unsigned bits = 64;
  const Available<std::array<Real, 3>> parts = texture_parts(system, curve);
  TexturePlace place{};
  for (std::size_t i = 0; i < place.size(); ++i)
    place.at(i) = (*parts).at(i).ball(bits).lower().convert_to<double>();
  constexpr std::array<Mark, 4> marks = {Mark::disc, Mark::square, Mark::triangle, Mark::diamond};
  Series s = line_of({place}, series_color(number), 1);
  s.stroke = Stroke::none;
  s.mark = marks.at(number / series_colors % marks.size());
  s.mark_size = 1;
  return s;
}

Panel diagram_panel(const TextureDiagram &diagram, Language language) {
  constexpr double beside = 0.14, below = 0.06, above = 0.03;
  Panel panel;
  panel.framed = false;
  panel.x.low = -beside;
  panel.x.high = 1 + beside;
  panel.y.low = -below;
  panel.y.high = triangle_height + above;
  std::array<std::string, 3> names;
  std::transform(diagram.parts.begin(), diagram.parts.end(), names.begin(),
                 [language](std::string_view part) { return band_names(part, language).front(); });
  add_scales(panel, names);
  for (const auto &[from, to] : diagram.lines)
    panel.series.push_back(line_of({from, to}, field_color, 1));
  panel.series.push_back(line_of({{100, 0, 0}, {0, 100, 0}, {0, 0, 100}, {100, 0, 0}}, outline_color, 1.2));
  for (const TextureField &field : diagram.fields)
    panel.texts.push_back(label_of(field));
  return panel;
}

} // namespace

Figure texture_figure(TextureSystem system, const std::vector<NamedCurve> &curves, const FigureForm &form) {
  const FigureTexts &texts = figure_texts(form.language);
  const TextureDiagram &diagram = texture_diagram(system);
  Figure figure;
  figure.description = texts.texture_shown;
  figure.bare = form.bare;
  figure.notes = short_labels(diagram);
  figure.panels.push_back(diagram_panel(diagram, form.language));
  Panel &panel = figure.panels.front();
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Available<std::string> name = texture(system, curves[i].curve);
    if (!name) {
      figure.remarks.push_back(
          fmt::format("{}: {}: {}.", curves[i].name, texts.no_texture, name.why().reason));
      continue;
    }
    panel.series.push_back(mark_of(system, curves[i].curve, i));
    panel.series.back().title = fmt::format("{}: {}", curves[i].name, *name);
  }
  if (form.width > 0)
    figure.panel_width = panel_width_in(form.width, figure);
  figure.panel_height = figure.panel_width * panel.y.span() / panel.x.span();
  return figure;
}

} // namespace mdm
