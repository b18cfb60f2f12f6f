#include "plot/timesteps_figure.hpp"

#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <functional>

namespace mdm {
namespace {

/// A line of a panel.
struct Drawn {
  const char *title;
  const char *color;
  std::function<std::optional<Interval>(const TimestepState &)> value;
};

double middle(const Interval &y) {
  return Rational((y.lo + y.hi) / 2).convert_to<double>();
}

/// The line of what is available; a timestep without it is passed over.
Series drawn_line(const Drawn &drawn, const std::vector<TimestepState> &states) {
  constexpr std::size_t most_marks = 60;
  Series s;
  s.title = drawn.title;
  s.color = drawn.color;
  for (const TimestepState &state : states)
    if (const std::optional<Interval> y = drawn.value(state))
      s.points.push_back({state.timestep.convert_to<double>(), middle(*y)});
  if (s.points.size() <= most_marks) {
    s.mark = Mark::disc;
    s.mark_size = 0.6;
  }
  return s;
}

/// From 0, or below it, to the largest value.
Axis value_axis(const std::string &title, const std::vector<Series> &lines) {
  double low = 0, high = 0;
  for (const Series &s : lines)
    for (const Point &p : s.points) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  return linear_axis(title, low, high > low ? high : low + 1);
}

/// Adds a panel of these lines, if there is something in it.
void add_panel(Figure &figure, const std::vector<TimestepState> &states, const char *title, const char *unit,
               const std::vector<Drawn> &all) {
  Panel panel;
  for (const Drawn &drawn : all)
    if (Series s = drawn_line(drawn, states); !s.points.empty())
      panel.series.push_back(std::move(s));
  if (panel.series.empty())
    return;
  const auto [first, last] =
      std::minmax_element(states.begin(), states.end(), [](const TimestepState &a, const TimestepState &b) {
        return a.timestep < b.timestep;
      });
  const double from = first->timestep.convert_to<double>(), to = last->timestep.convert_to<double>();
  panel.title = title;
  panel.x = linear_axis("timestep", from, to > from ? to : from + 1);
  panel.y = value_axis(unit, panel.series);
  panel.grid = true;
  figure.panels.push_back(std::move(panel));
}

/// In percent.
Interval in_percent(const Interval &share) {
  return {Rational(100 * share.lo), Rational(100 * share.hi)};
}

} // namespace

Figure timesteps_figure(const TimestepsReport &r) {
  if (r.states.size() < 2)
    throw InputError("there is one timestep alone, and nothing to draw over time: leave out " +
                     option("plot"));
  Figure figure;
  figure.title = r.sample + " against " + r.gradation.id();
  figure.description = "What a sample of particles is at each timestep, measured against a gradation.";
  figure.remarks = r.notes;
  figure.panel_width = 430;
  figure.panel_height = 250;
  figure.columns = 2;
  const auto fines_lost = [&r](const TimestepState &s) -> std::optional<Interval> {
    const std::optional<Rational> lost = r.fines_lost(s);
    return lost ? std::optional(in_percent(*lost)) : std::nullopt;
  };
  const auto mean = [](const TimestepState &s) -> std::optional<Interval> {
    return s.packing && s.packing->coordination.spheres > 0
               ? std::optional<Interval>(s.packing->coordination.mean())
               : std::nullopt;
  };
  const auto mean_of_others = [](const TimestepState &s) -> std::optional<Interval> {
    const std::optional<Rational> z =
        s.packing ? s.packing->coordination.mean_without_rattlers() : std::nullopt;
    return z ? std::optional<Interval>(*z) : std::nullopt;
  };
  const auto void_ratio = [](const TimestepState &s) {
    return s.packing ? std::optional(s.packing->void_ratio) : std::nullopt;
  };
  const auto segregation = [](const TimestepState &s) {
    return s.packing ? s.packing->segregation : std::nullopt;
  };
  add_panel(figure, r.states, "shares of the classes", "percent",
            {{"largest error of a share", "#1f4e79",
              [](const TimestepState &s) { return in_percent(s.maximum_error); }},
             {"fines lost, of their number", "#c55a11", fines_lost}});
  add_panel(figure, r.states, "coordination", "contacts of a particle",
            {{"Z, all particles", "#0e7c86", mean}, {"Z without rattlers", "#c0392b", mean_of_others}});
  add_panel(figure, r.states, "places", "",
            {{"void ratio", "#7d3c98", void_ratio}, {"segregation by height", "#b9770e", segregation}});
  add_panel(figure, r.states, "relative breakage", "",
            {{"B_r of Hardin", "#5d6d7e", [](const TimestepState &s) { return s.hardin; }},
             {"B of Einav", "#6e2c00", [](const TimestepState &s) { return s.einav; }}});
  return figure;
}

} // namespace mdm
