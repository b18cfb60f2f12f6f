#include "papers/size_model_figures.hpp"

#include "papers/shape_lines.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <array>
#include <map>

namespace mdm {
namespace {

constexpr double panel_width = 430;

double log10_of(const Integer &n) {
  return mdm::log10_of(Rational(n));
}

const Shape &shape_of(const SetRow &row) {
  return row.question.shape;
}

/// Solid with marks for geometric classes, dashed for regular ones.
template <class Belongs, class PointOf>
std::vector<Series> set_lines(const std::vector<SetRow> &rows, Belongs belongs, PointOf point) {
  std::vector<Series> lines;
  for (const Classing classing : {Classing::geometric, Classing::regular}) {
    std::vector<Series> some = shape_lines(
        rows, shape_of, [&](const SetRow &r) { return r.question.classing == classing && belongs(r); },
        point);
    for (Series &line : some) {
      if (classing == Classing::regular) {
        line.title += ", regular classes";
        line.stroke = Stroke::dashed;
        line.mark = Mark::ring;
      } else {
        line.mark = Mark::disc;
      }
      line.mark_size = 0.4;
      line.width = 1.2;
      lines.push_back(std::move(line));
    }
  }
  return lines;
}

/// Bars from the least to the greatest C_r of each set, in the colours of the lines.
template <class Across>
void add_bars(Panel &panel, const std::vector<SetRow> &rows, Across across) {
  std::vector<Series> bars;
  for (const Series &line : panel.series) {
    bars.push_back(line);
    bars.back().title.clear();
    bars.back().points.clear();
    bars.back().mark = Mark::none;
    bars.back().stroke = Stroke::solid;
    bars.back().width = 0.6;
  }
  // The lines are those of the shapes with geometric classes, then those with regular ones.
  const std::vector<Shape> shapes = compared_shapes();
  for (const SetRow &row : rows) {
    if (row.c_r.empty())
      continue;
    const auto at = std::find_if(shapes.begin(), shapes.end(),
                                 [&](const Shape &s) { return same_shape(s, shape_of(row)); });
    const auto i = static_cast<std::size_t>(at - shapes.begin()) +
                   (row.question.classing == Classing::regular ? shapes.size() : 0);
    Series &bar = bars.at(i);
    bar.points.push_back({across(row), mdm::log10_of(row.least().lo)});
    bar.points.push_back({across(row), mdm::log10_of(row.greatest().hi)});
    bar.points.push_back({no_number, no_number});
  }
  for (Series &bar : bars)
    panel.series.push_back(std::move(bar));
}

/// N_max of the accessible domains, and what is beyond them.
struct Level {
  unsigned power; ///< of ten
  const char *title, *color;
};
constexpr std::array<Level, 4> levels = {{{4, "10\u2074", "#1f4e79"},
                                          {5, "10\u2075", "#5b9bd5"},
                                          {6, "10\u2076", "#bdd7ee"},
                                          {1000, "more", "#f4d9c6"}}};

Panel shape_panel(const std::string &name) {
  Panel panel;
  panel.title = name;
  panel.x = linear_axis("a", 0, 12.5);
  panel.y = linear_axis("b", 0, 12.5);
  panel.x.high = panel.y.high = 12.5;
  return panel;
}

/// Marks of this panel that touch each other.
Series cells() {
  Series series;
  series.stroke = Stroke::none;
  series.mark = Mark::square;
  series.mark_size = 1.7;
  return series;
}

/// The legend of the levels, in the corner where all maps are of one colour.
void add_levels(Panel &panel) {
  constexpr double left = 9.9, right = 12.3, low = 0.4, step = 0.62, sample = 10.3, name = 10.7;
  const double high = low + step * (static_cast<double>(levels.size()) + 1);
  Series field;
  field.points = {{left, low}, {right, low}, {right, high}, {left, high}, {left, low}};
  field.color = "#ffffff";
  field.edge = "#999999";
  field.filled = true;
  panel.series.push_back(std::move(field));
  double y = high - step / 2;
  panel.texts.push_back({left, y, "N up to", Align::left, 4, 0});
  for (const Level &level : levels) {
    y -= step;
    Series square;
    square.stroke = Stroke::none;
    square.mark = Mark::square;
    square.mark_size = 0.9;
    square.color = level.color;
    square.points = {{sample, y}};
    panel.series.push_back(std::move(square));
    panel.texts.push_back({name, y, level.title, Align::left, 0, 0});
  }
}

Panel level_panel(const std::vector<ShapeRow> &maps, Classing classing, const Rational &span) {
  Panel panel = shape_panel(fmt::format("s = {}, {} classes", to_decimal(span),
                                        classing == Classing::regular ? "regular" : "geometric"));
  for (const Level &level : levels) {
    Series series = cells();
    series.color = level.color;
    panel.series.push_back(std::move(series));
  }
  for (const ShapeRow &row : maps) {
    if (row.question.classing != classing || row.question.span != span)
      continue;
    std::size_t i = 0;
    while (row.particles > power_of_ten(levels.at(i).power))
      ++i;
    panel.series[i].points.push_back({to_double(row.question.shape.a), to_double(row.question.shape.b)});
  }
  add_levels(panel);
  return panel;
}

bool is_accessible(const ShapeRow &row) {
  return row.particles <= power_of_ten(6);
}

} // namespace

Figure distribution_figure(const std::vector<DistributionRow> &rows) {
  const auto line = [&](const char *title, const char *color, Real DistributionRow::*value) {
    Series series;
    series.title = title;
    series.color = color;
    for (const DistributionRow &r : rows)
      series.points.push_back({to_double(r.size), to_double(r.*value)});
    return series;
  };
  Panel densities = lines_panel({line("by number: f, F", shape_colors[0], &DistributionRow::number_density),
                                 line("by volume: V, h", shape_colors[1], &DistributionRow::volume_density)});
  densities.title = "f(d) and V(d)";
  densities.y = plain_axis("density (1/mm)", range_of(densities.series, &Point::y));
  Panel cumulative = lines_panel({line("by number: f, F", shape_colors[0], &DistributionRow::partition),
                                  line("by volume: V, h", shape_colors[1], &DistributionRow::grading)});
  cumulative.title = "F(d) and h(d)";
  cumulative.y = linear_axis("cumulative fraction", 0, 1);
  densities.x = cumulative.x = linear_axis("size d (mm)", 0, 0.01);
  Figure figure;
  figure.title = "One set of discs, a = b = 3, described by number and by volume";
  figure.columns = 2;
  figure.panel_width = panel_width;
  figure.panels = {std::move(densities), std::move(cumulative)};
  return figure;
}

Figure passing_figure(const std::vector<PassingRow> &rows) {
  Figure figure;
  figure.title = "Grading curves of the cumulative beta model";
  Panel panel = lines_panel(shape_lines(
      rows, [](const PassingRow &r) { return r.shape; }, [](const PassingRow &) { return true; },
      [](const PassingRow &r) {
        return Point{to_double(r.reduced), to_double(r.passing)};
      }));
  panel.x = linear_axis("reduced size (d - d_min) / (d_max - d_min)", 0, 1);
  panel.y = linear_axis("cumulative volume fraction h", 0, 1);
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure coefficient_figure(const std::vector<CoefficientRow> &rows) {
  Figure figure;
  figure.title = "Uniformity and curvature of the model over the size span";
  figure.columns = 2;
  figure.panel_width = panel_width;
  const auto lines = [&](auto value) {
    return shape_lines(
        rows, [](const CoefficientRow &r) { return r.shape; }, [](const CoefficientRow &) { return true; },
        [&](const CoefficientRow &r) {
          return Point{to_double(r.span), value(r)};
        });
  };
  const auto log10_of_real = [](const Real &y) { return mdm::log10_of(enclose(y, 15).lower()); };
  Panel c_u = lines_panel(lines([&](const CoefficientRow &r) { return log10_of_real(r.c_u); }));
  c_u.x = linear_axis("size span s", 0, 1);
  c_u.y = decades_axis("C_u", range_of(c_u.series, &Point::y));
  Panel c_c = lines_panel(lines([](const CoefficientRow &r) { return to_double(r.c_c); }));
  c_c.x = c_u.x;
  c_c.y = plain_axis("C_c", range_of(c_c.series, &Point::y));
  figure.panels = {std::move(c_u), std::move(c_c)};
  return figure;
}

Figure set_figure(const std::vector<SetRow> &rows, Criterion varied) {
  const auto across = [&](const SetRow &r) {
    const SetQuestion &q = r.question;
    return varied == Criterion::classes         ? static_cast<double>(q.classes)
           : varied == Criterion::min_per_class ? log10_of(q.wanted.min_per_class)
                                                : log10_of(q.wanted.at_least);
  };
  const auto axis = [&](const Range &range) {
    return varied == Criterion::classes         ? linear_axis("number of classes N_c", 0, range.high)
           : varied == Criterion::min_per_class ? decades_axis("least number in a class N_pc", range)
                                                : decades_axis("least number of particles N_min", range);
  };
  Panel n = lines_panel(set_lines(
      rows, [](const SetRow &r) { return r.counts.decided(); },
      [&](const SetRow &r) {
        return Point{across(r), log10_of(r.counts.particles())};
      }));
  n.x = axis(range_of(n.series, &Point::x));
  n.y = decades_axis("number of particles N", range_of(n.series, &Point::y));
  Panel c_r = lines_panel(set_lines(
      rows, [](const SetRow &r) { return !r.c_r.empty(); },
      [&](const SetRow &r) {
        return Point{across(r), mdm::log10_of(r.mean().lo)};
      }));
  add_bars(c_r, rows, across);
  c_r.x = n.x;
  c_r.y = decades_axis("regression coefficient C_r", range_of(c_r.series, &Point::y));
  Figure figure;
  figure.title = std::string("Sets of the model with s = 0.98 over ") +
                 (varied == Criterion::classes         ? "the number of classes"
                  : varied == Criterion::min_per_class ? "the least number of particles in a class"
                                                       : "the least number of particles");
  figure.columns = 2;
  figure.panel_width = panel_width;
  figure.notes = {"geometric classes,",
                  "where nothing else is said;",
                  "what is not varied: N_c = 10, N_pc = 10,",
                  "N_min = 2000;",
                  "C_r of sets up to 50,000 particles:",
                  "the mean of 10 draws, and a bar",
                  "from the least to the greatest"};
  figure.panels = {std::move(c_r), std::move(n)};
  return figure;
}

Figure accessible_figure(const std::vector<ShapeRow> &maps, const std::vector<ShapeRow> &spans) {
  Figure figure;
  figure.title =
      "Shapes of the model that are accessible with N particles: N_c = 10, N_pc = 10, N_min = 2000";
  figure.columns = 3;
  figure.panel_width = 330;
  figure.panel_height = 330;
  const Rational narrow = ratio(1, 10), wide = ratio(97, 100);
  figure.panels.push_back(level_panel(maps, Classing::regular, narrow));
  figure.panels.push_back(level_panel(maps, Classing::regular, wide));

  Panel map = shape_panel("C_u with 10\u2076 particles, s = 0.97, regular");
  Series uniform = cells();
  uniform.by_value = true;
  Range values;
  for (const ShapeRow &row : maps)
    if (row.question.classing == Classing::regular && row.question.span == wide && is_accessible(row)) {
      uniform.points.push_back({to_double(row.question.shape.a), to_double(row.question.shape.b),
                                mdm::log10_of(enclose(row.c_u, 15).lower())});
      values.cover(uniform.points.back().value);
    }
  map.series.push_back(std::move(uniform));
  figure.colors = plain_axis("log10 C_u", values);
  figure.panels.push_back(std::move(map));

  figure.panels.push_back(level_panel(maps, Classing::geometric, narrow));
  figure.panels.push_back(level_panel(maps, Classing::geometric, wide));

  std::map<Rational, Range> reach;
  for (const ShapeRow &row : spans)
    if (is_accessible(row))
      reach[row.question.span].cover(mdm::log10_of(enclose(row.c_u, 15).lower()));
  Series least, greatest;
  for (const auto &[span, range] : reach) {
    least.points.push_back({to_double(span), range.low});
    greatest.points.push_back({to_double(span), range.high});
  }
  greatest.color = shape_colors[1];
  Panel over = lines_panel({std::move(greatest), std::move(least)});
  for (Series &line : over.series)
    line.mark = Mark::disc;
  over.title = "C_u with 10\u2076 particles, regular, whole a and b to 10";
  over.x = linear_axis("size span s", 0, 1);
  over.y = decades_axis("C_u", range_of(over.series, &Point::y));
  const std::pair<const char *, std::size_t> names[] = {{"largest", 0}, {"smallest", 1}};
  for (const auto &[name, i] : names)
    if (!over.series[i].points.empty()) {
      const Point &last = over.series[i].points.back();
      over.texts.push_back({last.x, last.y, name, Align::right, -12, i == 0 ? 8.0 : 14.0});
    }
  figure.panels.push_back(std::move(over));
  return figure;
}

} // namespace mdm
