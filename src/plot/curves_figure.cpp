#include "plot/curves_figure.hpp"

#include "plot/figure_layout.hpp"
#include "plot/limits_series.hpp"
#include "plot/palette.hpp"
#include "soil/grading_curve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace mdm {
namespace {

constexpr const char *missed_color = "#e60000";

/// The points of the curve whose sizes are above 0.
std::vector<Point> curve_points(const GradingCurve &curve) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < curve.shares().size(); ++i)
    if (const Rational size = drawn_size(curve.opening(i)); size > 0)
      points.push_back({log10_of(size), 100 * curve.shares()[i].convert_to<double>()});
  return points;
}

/// The i-th curve of the figure.
Series curve_series(const DrawnCurve &c, const GradingCurve &curve, std::size_t i) {
  Series s;
  s.points = curve_points(curve);
  s.color = series_color(i);
  s.width = c.weight == DrawnCurve::Weight::thin ? 0.9 : 2;
  constexpr std::array<Stroke, 3> strokes = {Stroke::solid, Stroke::dashed, Stroke::dotted};
  s.stroke = c.weight == DrawnCurve::Weight::dashed ? Stroke::dashed
                                                    : strokes.at(i / series_colors % strokes.size());
  constexpr std::size_t most_marks = 60;
  if (c.weight == DrawnCurve::Weight::thick && s.points.size() <= most_marks) {
    s.mark = Mark::disc;
    s.mark_size = 0.6;
  }
  return s;
}

/// Rings around the curve where it misses a limit.
Series missed_series(const DrawnCurve &c, const GradingCurve &curve, const std::string &title) {
  Series s;
  s.title = title;
  s.color = missed_color;
  s.stroke = Stroke::none;
  s.mark = Mark::ring;
  s.mark_size = 1.3;
  constexpr unsigned bits = 64;
  for (const Rational &size : c.missed)
    if (const Available<Real> passing = curve.passing(size))
      s.points.push_back({log10_of(size), 100 * passing->ball(bits).lower().convert_to<double>()});
  return s;
}

/// From the finest to the coarsest of all that is drawn, with room beside it.
Axis size_axis(const std::vector<Series> &all, std::string_view title) {
  double low = 0, high = 0;
  bool is_first = true;
  for (const Series &s : all)
    for (const Point &p : s.points) {
      low = is_first ? p.x : std::min(low, p.x);
      high = is_first ? p.x : std::max(high, p.x);
      is_first = false;
    }
  const double room = 0.06 * (high > low ? high - low : 1);
  return log_axis(fmt::format("{} (mm)", title), low - room, high + room);
}

/// The names of the curves, of the same ones the second and so on with its number.
std::vector<std::string> distinct_names(const std::vector<DrawnCurve> &curves) {
  std::map<std::string, unsigned> seen;
  std::vector<std::string> names;
  for (const DrawnCurve &c : curves) {
    const unsigned number = ++seen[c.name];
    names.push_back(number == 1 ? c.name : fmt::format("{} ({})", c.name, number));
  }
  return names;
}

Panel curves_panel(const CurvesFigure &what, const FigureTexts &texts) {
  Panel p;
  p.y = {std::string(texts.passing), 0, 100, {}};
  for (int i = 0; i <= 100; i += 10) {
    p.y.ticks.push_back({static_cast<double>(i), std::to_string(i)});
    p.right.push_back({static_cast<double>(i), std::to_string(100 - i)});
  }
  p.right_title = texts.retained;
  p.grid = true;
  if (what.limits)
    p.series = limits_series(*what.limits, 1, std::string(texts.allowed) + what.limits->id);
  const std::vector<std::string> names = distinct_names(what.curves);
  std::vector<Series> missed;
  for (std::size_t i = 0; i < what.curves.size(); ++i) {
    const GradingCurve curve(what.curves[i].gradation);
    p.series.push_back(curve_series(what.curves[i], curve, i));
    p.series.back().title = names[i];
    if (!what.curves[i].missed.empty())
      missed.push_back(missed_series(what.curves[i], curve, std::string(texts.missed)));
  }
  p.series.insert(p.series.end(), missed.begin(), missed.end());
  p.x = size_axis(p.series, texts.size);
  return p;
}

} // namespace

Figure curves_figure(const CurvesFigure &what) {
  const FigureTexts &texts = figure_texts(what.form.language);
  Figure figure;
  figure.title = what.title;
  figure.description = texts.curves_shown;
  figure.bare = what.form.bare;
  figure.panels.push_back(curves_panel(what, texts));
  if (what.form.width > 0) {
    constexpr double least_height = 210;
    figure.panel_width = panel_width_in(what.form.width, figure);
    figure.panel_height = std::min(figure.panel_height, std::max(least_height, 0.42 * what.form.width));
  }
  return figure;
}

} // namespace mdm
