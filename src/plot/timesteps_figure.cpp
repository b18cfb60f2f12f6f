#include "plot/timesteps_figure.hpp"

#include "plot/ranges.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <functional>

namespace mdm {
namespace {

/// A line of a panel.
struct Drawn {
  const char *title;
  const char *color;
  std::function<std::optional<Interval>(const TimestepState &)> value;
};

/// The line of what is available; a timestep without it is passed over.
Series drawn_line(const Drawn &drawn, const std::vector<TimestepState> &states) {
  constexpr std::size_t most_marks = 60;
  Series s;
  s.title = drawn.title;
  s.color = drawn.color;
  for (const TimestepState &state : states)
    if (const std::optional<Interval> y = drawn.value(state))
      s.points.push_back({to_double(Rational(state.timestep)), to_double(Rational((y->lo + y->hi) / 2))});
  if (s.points.size() <= most_marks) {
    s.mark = Mark::disc;
    s.mark_size = 0.6;
  }
  return s;
}

/// Of all lines; of one value alone some room around it.
Axis axis_of(const std::string &title, Range range) {
  if (range.low == range.high)
    range.cover(range.low + 1);
  return plain_axis(title, range);
}

/// Adds a panel of these lines, if there is something in it.
void add_panel(Figure &figure, const std::vector<TimestepState> &states, const char *title, const char *unit,
               const std::vector<Drawn> &all) {
  Panel panel;
  Range x, y;
  y.cover(0);
  for (const Drawn &drawn : all)
    if (Series s = drawn_line(drawn, states); !s.points.empty())
      panel.series.push_back(std::move(s));
  if (panel.series.empty())
    return;
  for (const TimestepState &state : states)
    x.cover(to_double(Rational(state.timestep)));
  for (const Series &s : panel.series)
    for (const Point &p : s.points)
      y.cover(p.y);
  panel.title = title;
  panel.x = axis_of("timestep", x);
  panel.y = axis_of(unit, y);
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
  add_panel(figure, r.states, "shares of the classes", "percent",
            {{"largest error of a share", "#1f4e79",
              [](const TimestepState &s) { return in_percent(s.maximum_error); }},
             {"fines lost, of their number", "#c55a11", fines_lost}});
  add_panel(figure, r.states, "coordination", "contacts of a particle",
            {{"Z, all particles", "#0e7c86", &TimestepState::coordination},
             {"Z without rattlers", "#c0392b", &TimestepState::coordination_without_rattlers}});
  add_panel(figure, r.states, "places", "",
            {{"void ratio", "#7d3c98", &TimestepState::void_ratio},
             {"segregation by height", "#b9770e", &TimestepState::segregation}});
  add_panel(figure, r.states, "relative breakage", "",
            {{"B_r of Hardin", "#5d6d7e", &TimestepState::hardin},
             {"B of Einav", "#6e2c00", &TimestepState::einav}});
  return figure;
}

} // namespace mdm
