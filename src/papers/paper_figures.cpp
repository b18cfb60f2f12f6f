#include "papers/paper_figures.hpp"

#include "papers/paper_tables.hpp"
#include "plot/ranges.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>

namespace mdm {
namespace {

constexpr const char *exact_color = "#1f4e79";
constexpr const char *published_color = "#c55a11";

/// The first sieve that is drawn: the second where the first is a pan far below it, which would take half of
/// the axis.
std::size_t first_drawn(const SurveyRow &row) {
  constexpr int far = 10;
  return row.sizes[1] > far * row.sizes[0] ? 1 : 0;
}

/// The points of a curve in log size, from `from` on.
std::vector<Point> curve_points(const SurveyRow &row, std::size_t from) {
  std::vector<Point> points;
  for (std::size_t j = from; j < row.sizes.size(); ++j)
    if (row.sizes[j] > 0)
      points.push_back({log10_of(row.sizes[j]), 100 * to_double(row.passing[j])});
  return points;
}

void append_line(Series &series, const std::vector<Point> &points) {
  series.points.insert(series.points.end(), points.begin(), points.end());
  series.points.push_back({no_number, no_number});
}

Panel curves_panel(const std::vector<SurveyRow> &rows, std::optional<std::size_t> example) {
  Series curves;
  curves.color = "#9fb6cd";
  curves.width = 0.6;
  Range sizes;
  std::size_t shown = 0;
  for (std::size_t i = 0; i < rows.size(); i += subset_step, ++shown) {
    const std::vector<Point> points = curve_points(rows[i], first_drawn(rows[i]));
    for (const Point &p : points)
      sizes.cover(p.x);
    append_line(curves, points);
  }
  curves.title = fmt::format("gradations ({} of {})", shown, rows.size());
  Panel panel;
  panel.x = decades_axis("size (mm)", sizes);
  panel.y = linear_axis("percent passing", 0, 100);
  panel.grid = true;
  panel.series.push_back(std::move(curves));
  if (example) {
    Series one;
    one.title = "the example: " + rows[*example].id;
    one.points = curve_points(rows[*example], first_drawn(rows[*example]));
    one.color = published_color;
    one.width = 2;
    panel.series.push_back(std::move(one));
  }
  return panel;
}

/// The area under the curve above the level P(x_2), and the triangle that it is measured by.
Panel index_panel(const SurveyRow &row) {
  const std::vector<Point> points = curve_points(row, 1);
  const Point first = points.front(), last = points.back();
  Series area;
  area.title = "area above the level P(x_2)";
  area.points = points;
  area.points.push_back({last.x, first.y});
  area.points.push_back(first);
  area.color = "#f4d9c6";
  area.filled = true;
  Series triangle;
  triangle.title = "triangle: I_C = 1";
  triangle.points = {first, last, {last.x, first.y}, first};
  triangle.color = "#333333";
  triangle.stroke = Stroke::dashed;
  Series curve;
  curve.title = "the example: " + row.id;
  curve.points = curve_points(row, first_drawn(row));
  curve.color = published_color;
  curve.width = 2;
  curve.mark = Mark::disc;
  Range sizes;
  for (const Point &p : curve.points)
    sizes.cover(p.x);
  Panel panel;
  panel.title = fmt::format("{}: I_C = {}", row.id, rounded(*row.i_c, 3));
  panel.x = decades_axis("size (mm)", sizes);
  panel.y = linear_axis("percent passing", 0, 100);
  panel.grid = true;
  panel.series = {std::move(area), std::move(triangle), std::move(curve)};
  return panel;
}

/// From 0 to just above the last iteration.
Axis iteration_axis(std::uint64_t most) {
  Axis axis = linear_axis("iteration (multiple i of K)", 0, static_cast<double>(most) + 1);
  axis.high = static_cast<double>(most) + 1;
  axis.ticks.erase(std::remove_if(axis.ticks.begin(), axis.ticks.end(),
                                  [&axis](const Tick &t) { return t.at > axis.high; }),
                   axis.ticks.end());
  return axis;
}

/// Logarithmic; below it, behind a line and shaded, a level for no error at all.
void set_error_axis(Panel &panel, const Range &errors) {
  constexpr double to_line = 0.4, to_zero = 0.8, to_frame = 1.2;
  Axis axis = decades_axis("total error (percent of the mass)", errors);
  axis.high = std::max(axis.high, 1.0);
  const double least = axis.low;
  axis.ticks.insert(axis.ticks.begin(), {least - to_zero, "0"});
  axis.low = least - to_frame;
  panel.back.push_back({panel.x.low, panel.x.high, axis.low, least - to_line, "#ececec"});
  Series line;
  line.points = {{panel.x.low, least - to_line}, {panel.x.high, least - to_line}};
  line.color = "#333333";
  line.width = 0.75;
  panel.series.push_back(std::move(line));
  panel.y = std::move(axis);
}

/// A cloud of numbers of particles in log10, with what is common to Figures 3 to 5.
struct Cloud {
  std::string title;
  std::optional<Integer> (*count)(const SurveyRow &);
};

std::optional<Integer> exact_count(const SurveyRow &row) {
  return row.counts.exact;
}

std::optional<Integer> published_count(const SurveyRow &row) {
  return row.counts.spanned_integer;
}

const Cloud clouds[] = {{"smallest match, exact", exact_count},
                        {"paper's SI code, x_nS mid-class", published_count}};

constexpr const char *count_title = "N_MDM (particles)";

Axis count_axis(const std::vector<SurveyRow> &rows) {
  Range range;
  for (const SurveyRow &row : rows)
    for (const Cloud &cloud : clouds)
      if (const std::optional<Integer> n = cloud.count(row))
        range.cover(log10_of(Rational(*n)));
  return decades_axis(count_title, range);
}

/// N over something, beside it the same with the published N; the colour is log10 zeta_1.
template <class Across>
Figure colored_clouds(const std::vector<SurveyRow> &rows, const std::string &title,
                      Axis (*axis)(const Range &), Across across) {
  Range abscissae, colors;
  for (const SurveyRow &row : rows)
    if (const std::optional<double> x = across(row)) {
      abscissae.cover(*x);
      colors.cover(log10_of(row.zeta_1));
    }
  Figure figure;
  figure.title = title;
  figure.columns = 2;
  figure.panel_width = 430;
  figure.colors = plain_axis("log10 zeta_1", colors);
  for (const Cloud &cloud : clouds) {
    Series series;
    series.stroke = Stroke::none;
    series.mark = Mark::disc;
    series.mark_size = 0.25;
    series.by_value = true;
    for (const SurveyRow &row : rows) {
      const std::optional<double> x = across(row);
      const std::optional<Integer> n = cloud.count(row);
      if (x && n)
        series.points.push_back({*x, log10_of(Rational(*n)), log10_of(row.zeta_1)});
    }
    Panel panel;
    panel.title = cloud.title;
    panel.x = axis(abscissae);
    panel.y = count_axis(rows);
    panel.grid = true;
    panel.series.push_back(std::move(series));
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

/// The order of the groups in Figure 5: gravels, then sands, then fine soils, as in the standard.
std::string group_order(const UscsGroup &group) {
  return (group.symbol[0] == 'G'   ? "1"
          : group.symbol[0] == 'S' ? "2"
                                   : "3") +
         group.symbol + "\t" + group.name;
}

} // namespace

Figure paper_figure1(const std::vector<SurveyRow> &rows) {
  const std::optional<std::size_t> example = figure1_example(rows);
  Figure figure;
  figure.title = "Grain size distributions, and the curvature index of one";
  figure.columns = 2;
  figure.panel_width = 430;
  figure.panels.push_back(curves_panel(rows, example));
  if (std::any_of(rows.begin(), rows.end(), [](const SurveyRow &row) { return first_drawn(row) == 1; }))
    figure.notes = {"A curve begins at its finest sieve", "where the pan is less than a tenth of it."};
  if (example)
    figure.panels.push_back(index_panel(rows[*example]));
  return figure;
}

Figure paper_figure2(const std::vector<Convergence> &runs) {
  Range errors;
  std::uint64_t most = 1;
  for (const Convergence &c : runs)
    for (const Published *run : {&c.spanned_integer, &c.fixed_size})
      for (const PublishedTry &t : run->tries) {
        most = std::max(most, t.multiple);
        if (t.error.total > 0)
          errors.cover(log10_of(Rational(100 * t.error.total)));
      }
  Panel panel;
  panel.x = iteration_axis(most);
  set_error_axis(panel, errors);
  panel.grid = true;
  const auto series = [&](const char *title, const char *color, Published Convergence::*run) {
    Series s;
    s.title = title;
    s.color = color;
    s.mark = Mark::disc;
    s.mark_size = 0.3;
    s.width = 0.7;
    for (const Convergence &c : runs) {
      std::vector<Point> points;
      for (const PublishedTry &t : (c.*run).tries)
        points.push_back({static_cast<double>(t.multiple), t.error.total > 0
                                                               ? log10_of(Rational(100 * t.error.total))
                                                               : panel.y.ticks.front().at});
      append_line(s, points);
    }
    return s;
  };
  Series tolerance;
  tolerance.title = "tolerance of FS: 1 %";
  tolerance.points = {{panel.x.low, 0}, {panel.x.high, 0}};
  tolerance.color = "#333333";
  tolerance.stroke = Stroke::dashed;
  panel.series.push_back(series("fixed size (FS)", published_color, &Convergence::fixed_size));
  panel.series.push_back(series("spanned integer (SI)", exact_color, &Convergence::spanned_integer));
  panel.series.push_back(std::move(tolerance));
  const auto at_once = std::count_if(runs.begin(), runs.end(), [](const Convergence &c) {
    return c.spanned_integer.tries.size() == 1 && c.spanned_integer.is_match();
  });
  Figure figure;
  figure.notes = {fmt::format("SI has no error at once in {}", at_once), "shaded: no error at all, which",
                  "a logarithmic axis does not reach"};
  figure.title = fmt::format("Convergence of the published algorithms, {} gradations", runs.size());
  figure.panels.push_back(std::move(panel));
  return figure;
}

Figure paper_figure3(const std::vector<SurveyRow> &rows) {
  return colored_clouds(
      rows, "Particles of the smallest match over the mass ratio of the finest class",
      [](const Range &range) { return decades_axis("phi_1 (mass of the finest class / coarsest)", range); },
      [](const SurveyRow &row) { return std::optional(log10_of(row.phi_1)); });
}

Figure paper_figure4(const std::vector<SurveyRow> &rows) {
  return colored_clouds(
      rows, "Particles of the smallest match over the curvature index",
      [](const Range &range) { return plain_axis("curvature index I_C", range); },
      [](const SurveyRow &row) { return row.i_c ? std::optional(to_double(*row.i_c)) : std::nullopt; });
}

Figure paper_figure5(const std::vector<SurveyRow> &rows) {
  std::map<std::string, std::vector<const SurveyRow *>> groups;
  Range abscissae;
  for (const SurveyRow &row : rows)
    if (row.group && row.i_gs) {
      groups[group_order(*row.group)].push_back(&row);
      abscissae.cover(to_double(*row.i_gs));
    }
  Figure figure;
  figure.title = "Particles of the smallest match by USCS group";
  figure.notes = {"in each panel: group symbol", "and number of gradations"};
  figure.columns = 4;
  figure.panel_width = 250;
  figure.panel_height = 260;
  const auto series_of = [](const Cloud &cloud, const std::vector<const SurveyRow *> &members) {
    Series series;
    series.stroke = Stroke::none;
    for (const SurveyRow *row : members)
      if (const std::optional<Integer> n = cloud.count(*row))
        series.points.push_back({to_double(*row->i_gs), log10_of(Rational(*n))});
    series.title = cloud.title;
    return series;
  };
  for (const auto &[order, members] : groups) {
    const UscsGroup &group = *members.front()->group;
    Panel panel;
    panel.title = group.name;
    panel.x = plain_axis("I_GS", abscissae);
    panel.y = count_axis(rows);
    panel.grid = true;
    panel.series = {series_of(clouds[0], members), series_of(clouds[1], members)};
    panel.texts.push_back(
        {panel.x.low, panel.y.high, fmt::format("{}: {}", group.symbol, members.size()), Align::left, 4, -8});
    panel.series[0].color = exact_color;
    panel.series[0].mark = Mark::disc;
    panel.series[0].mark_size = 0.22;
    panel.series[1].color = "#f08c3c"; // open and in front: where the two are near, both are seen
    panel.series[1].mark = Mark::ring;
    panel.series[1].mark_size = 0.35;
    figure.panels.push_back(std::move(panel));
  }
  return figure;
}

} // namespace mdm
