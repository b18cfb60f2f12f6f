#include "plot/tradeoff_figure.hpp"

#include "plot/figure_layout.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

constexpr const char *count_color = "#1f4e79";
constexpr const char *lost_color = "#c55a11";

/// n in full, or its first digits where it is long.
std::string short_count(const Integer &n) {
  constexpr std::size_t longest = 9;
  const std::string digits = to_string(n);
  if (digits.size() <= longest)
    return digits;
  return fmt::format("{}.{}e{}", digits.substr(0, 1), digits.substr(1, 2), digits.size() - 1);
}

double log10_of_count(const Integer &n) {
  return log10_of(Rational(n));
}

/// A rectangle of the picture, in pt.
struct Area {
  double left, right, bottom, top;

  bool overlaps(const Area &a) const {
    return left < a.right && a.left < right && bottom < a.top && a.bottom < top;
  }
};

/// Labels of the points of one panel: each where it covers no line, no mark and no other label, or nowhere.
class Labels {
public:
  Labels(Panel &panel, const Figure &figure)
      : panel_(panel), width_(figure.panel_width), height_(figure.panel_height) {
    for (const Series &s : panel.series)
      add_obstacles(s);
  }

  void add(const Point &p, const std::string &text) {
    constexpr double away = 8;
    constexpr double gap = 4;
    const double width = text_width(text, letter_size);
    for (const double dy : {away, 2.2 * away, -away, -2.2 * away, 3.4 * away})
      for (const Align align : {Align::left, Align::center, Align::right}) {
        const double dx = align == Align::left ? away / 2 : align == Align::right ? -away / 2 : 0;
        const double start = across(p.x) + dx -
                             (align == Align::left     ? 0
                              : align == Align::center ? width / 2
                                                       : width);
        const double middle = up(p.y) + dy;
        const Area area{start, start + width, middle - letter_size / 2, middle + letter_size / 2};
        if (!is_free(area))
          continue;
        taken_.push_back({area.left - gap, area.right + gap, area.bottom, area.top});
        panel_.texts.push_back({p.x, p.y, text, align, dx, dy});
        return;
      }
  }

private:
  double across(double x) const { return (x - panel_.x.low) / panel_.x.span() * width_; }
  double up(double y) const { return (y - panel_.y.low) / panel_.y.span() * height_; }

  bool is_free(const Area &area) const {
    return area.left > 0 && area.right < width_ && area.bottom > 0 && area.top < height_ &&
           std::none_of(taken_.begin(), taken_.end(), [&](const Area &a) { return a.overlaps(area); });
  }

  /// Marks, and lines as small squares along them.
  void add_obstacles(const Series &s) {
    constexpr double mark = 4;
    constexpr double step = 4;
    const auto add = [this](double x, double y, double half) {
      taken_.push_back({x - half, x + half, y - half, y + half});
    };
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      const double x = across(s.points[i].x);
      const double y = up(s.points[i].y);
      if (s.mark != Mark::none)
        add(x, y, mark);
      if (i == 0 || s.stroke == Stroke::none)
        continue;
      const double from_x = across(s.points[i - 1].x);
      const double from_y = up(s.points[i - 1].y);
      const double steps = std::ceil(std::hypot(x - from_x, y - from_y) / step);
      for (double k = 0; k <= steps; ++k)
        add(from_x + (x - from_x) * k / std::max(steps, 1.0),
            from_y + (y - from_y) * k / std::max(steps, 1.0), 1);
    }
  }

  Panel &panel_;
  double width_, height_; ///< of its frame, in pt
  std::vector<Area> taken_;
};

/// log10 of N, a decade or more, with room for labels; ticks from 1 on.
Axis count_axis(const std::vector<TradeoffRow> &rows, const FigureTexts &texts) {
  double low = log10_of_count(*rows.front().particles);
  double high = low;
  for (const TradeoffRow &row : rows) {
    low = std::min(low, log10_of_count(row.lower_bound));
    high = std::max(high, log10_of_count(*row.particles));
  }
  high = std::max(high, low + 1);
  const double span = high - low;
  Axis axis = log_axis(std::string(texts.count), low - 0.1 * span, high + 0.12 * span);
  axis.ticks.erase(axis.ticks.begin(), std::find_if(axis.ticks.begin(), axis.ticks.end(),
                                                    [](const Tick &t) { return t.at > -1e-9; }));
  return axis;
}

/// The axis that a curve is drawn over.
using Coordinate = Rational (*)(const TradeoffRow &row);

Rational drawn_tolerance(const TradeoffRow &row) {
  return row.tolerance;
}

Rational drawn_sieve(const TradeoffRow &row) {
  return drawn_size(row.smallest);
}

/// A logarithmic axis of such values, the least of which may be 0: this stands left of the others.
struct ValueAxis {
  Axis axis;
  bool has_zero;
  double zero; ///< its place

  double place(const Rational &value) const { return value == 0 ? zero : log10_of(value); }
};

ValueAxis value_axis(const std::string &title, const std::vector<Rational> &values,
                     std::string_view zero_label) {
  const bool has_zero = values.front() == 0;
  const std::size_t first = has_zero && values.size() > 1 ? 1 : 0;
  const double low = values[first] > 0 ? log10_of(values[first]) : 0;
  const double high = values.back() > 0 ? log10_of(values.back()) : 0;
  constexpr double least_span = 1e-9; // what doubles can tell apart
  const double span = high - low > least_span ? high - low : 1;
  const double zero = low - 0.25 * span;
  Axis axis{title, (has_zero ? zero : low) - 0.06 * span, high + 0.12 * span, {}};
  for (const Rational &value : values)
    axis.ticks.push_back(
        {value == 0 ? zero : log10_of(value), value == 0 ? std::string(zero_label) : to_decimal(value)});
  return {axis, has_zero, zero};
}

/// N along an axis: its points, a dotted line from the one at 0, bars down to what is proved.
Panel count_panel(std::string_view title, const ValueAxis &x, const std::vector<TradeoffRow> &rows,
                  Coordinate value, const FigureTexts &texts) {
  Panel panel;
  panel.title = title;
  panel.x = x.axis;
  panel.y = count_axis(rows, texts);
  panel.grid = true;
  Series curve;
  curve.title = texts.proved;
  curve.color = count_color;
  Series optimal = curve;
  optimal.stroke = Stroke::none;
  optimal.mark = Mark::disc;
  optimal.mark_size = 0.8;
  curve.title.clear();
  curve.width = 2;
  Series open = optimal;
  open.title = texts.at_limit;
  open.mark = Mark::ring;
  Series to_zero = curve;
  to_zero.stroke = Stroke::dotted;
  std::vector<Series> bars;
  for (const TradeoffRow &row : rows) {
    const Point p{x.place(value(row)), log10_of_count(*row.particles)};
    if (row.is_optimal()) {
      optimal.points.push_back(p);
    } else {
      open.points.push_back(p);
      Series bar = curve;
      bar.width = 1;
      bar.points = {{p.x, log10_of_count(row.lower_bound)}, p};
      bars.push_back(bar);
    }
    if (value(row) != 0 || !x.has_zero)
      curve.points.push_back(p);
    if (to_zero.points.size() < 2)
      to_zero.points.push_back(p);
  }
  if (x.has_zero)
    panel.series.push_back(to_zero);
  panel.series.push_back(curve);
  panel.series.insert(panel.series.end(), bars.begin(), bars.end());
  for (const Series &marks : {optimal, open})
    if (!marks.points.empty())
      panel.series.push_back(marks);
  return panel;
}

/// The mass lost, on the right side.
void add_lost(Panel &panel, const ValueAxis &x, const std::vector<TradeoffRow> &rows,
              const FigureTexts &texts) {
  const auto at = [&panel](double percent) { return panel.y.low + percent / 100 * panel.y.span(); };
  panel.right_title = texts.lost;
  for (int percent = 0; percent <= 100; percent += 20)
    panel.right.push_back({at(percent), std::to_string(percent)});
  Series lost;
  lost.title = texts.lost_at_right;
  lost.color = lost_color;
  lost.stroke = Stroke::dashed;
  lost.mark = Mark::square;
  lost.mark_size = 0.6;
  for (const TradeoffRow &row : rows)
    lost.points.push_back({x.place(drawn_sieve(row)), at(100 * row.lost.convert_to<double>())});
  panel.series.insert(panel.series.begin(), lost);
}

void add_labels(Panel &panel, const Figure &figure, const ValueAxis &x, const std::vector<TradeoffRow> &rows,
                Coordinate value) {
  Labels labels(panel, figure);
  for (const TradeoffRow &row : rows)
    labels.add({x.place(value(row)), log10_of_count(*row.particles)}, short_count(*row.particles));
}

std::vector<Rational> values(const std::vector<TradeoffRow> &rows, Coordinate value) {
  std::vector<Rational> all;
  for (const TradeoffRow &row : rows)
    all.push_back(value(row));
  return all;
}

std::string tolerance_title(AskedTolerance::Kind kind, const FigureTexts &texts) {
  switch (kind) {
  case AskedTolerance::Kind::passing:
    return std::string(texts.of_passing);
  case AskedTolerance::Kind::total:
    return std::string(texts.of_total);
  default:
    return std::string(texts.of_retained);
  }
}

/// The rows that can be drawn.
/// \throws InputError if there are none
std::vector<TradeoffRow> with_match(std::vector<TradeoffRow> rows) {
  std::erase_if(rows, [](const TradeoffRow &row) { return !row.particles; });
  if (rows.empty())
    throw InputError("no match of a curve is known: nothing can be drawn: ask for less, or leave out " +
                     option("plot"));
  return rows;
}

} // namespace

Figure tradeoff_figure(const StatedTradeoff &t, const FigureForm &form) {
  const FigureTexts &texts = figure_texts(form.language);
  const std::vector<TradeoffRow> by_tolerance = with_match(t.by_tolerance), by_sieve = with_match(t.by_sieve);
  Figure figure;
  figure.title = t.id;
  figure.description = texts.tradeoff_shown;
  figure.remarks = t.notes;
  figure.bare = form.bare;
  const ValueAxis tolerance =
      value_axis(tolerance_title(t.kind, texts), values(by_tolerance, drawn_tolerance), "0");
  Panel left = count_panel(texts.by_tolerance, tolerance, by_tolerance, drawn_tolerance, texts);
  const ValueAxis sieve = value_axis(fmt::format("{} ({})", texts.smallest_sieve, name(t.unit)),
                                     values(by_sieve, drawn_sieve), texts.pan);
  Panel right = count_panel(t.question.empty() ? texts.exact_by_sieve : texts.by_sieve, sieve, by_sieve,
                            drawn_sieve, texts);
  add_lost(right, sieve, by_sieve, texts);
  figure.panels = {std::move(left), std::move(right)};
  set_two_panels(figure, 380, form);
  add_labels(figure.panels[0], figure, tolerance, by_tolerance, drawn_tolerance);
  add_labels(figure.panels[1], figure, sieve, by_sieve, drawn_sieve);
  return figure;
}

} // namespace mdm
