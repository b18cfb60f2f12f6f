#include "papers/accessible_report.hpp"

#include "answer/json_values.hpp"
#include "number/counted.hpp"
#include "plot/ranges.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <map>

namespace mdm {
namespace {

constexpr unsigned digits = 10;

std::string terms(const AccessibleQuestion &q) {
  return fmt::format("{} {} {}, at least {} in each and {} in all, at most {}, dimension {}", q.classes,
                     name(q.classing), q.classes == 1 ? "class" : "classes", counted(q.wanted.min_per_class),
                     to_string(q.wanted.at_least), to_string(q.at_most), q.wanted.dimension);
}

bool is_decided(const AccessibleRow &row) {
  return row.paper_accessible && row.match_accessible;
}

char letter(const AccessibleRow &row) {
  if (!is_decided(row))
    return '?';
  if (*row.paper_accessible)
    return *row.match_accessible ? 'B' : 'P';
  return *row.match_accessible ? 'M' : '.';
}

using Rows = std::vector<AccessibleRow>;

/// The rows of span i.
Rows rows_of_span(const AccessibleQuestion &q, const Rows &rows, std::size_t i) {
  const std::size_t n = q.a.size() * q.b.size();
  const auto begin = rows.begin() + static_cast<std::ptrdiff_t>(i * n);
  return {begin, begin + static_cast<std::ptrdiff_t>(n)};
}

std::ptrdiff_t count(const Rows &rows, std::optional<bool> AccessibleRow::*accessible) {
  return std::count_if(rows.begin(), rows.end(), [&](const auto &r) { return r.*accessible == true; });
}

/// b upwards, a to the right.
std::string letters(const AccessibleQuestion &q, const Rows &rows) {
  std::size_t width = 1;
  for (const Rational &b : q.b)
    width = std::max(width, to_decimal(b).size());
  std::string text;
  for (std::size_t j = q.b.size(); j-- > 0;) {
    text += fmt::format("  {:>{}} |", to_decimal(q.b[j]), width);
    for (std::size_t i = 0; i < q.a.size(); ++i)
      text += {' ', letter(rows[i * q.b.size() + j])};
    text += "\n";
  }
  text += fmt::format("  {:>{}}   a from {} to {}\n", "b", width, to_decimal(q.a.front()),
                      to_decimal(q.a.back()));
  return text;
}

/// A field of CSV.
std::string field(const std::optional<Integer> &n) {
  return n ? to_string(*n) : "";
}

std::string field(const std::optional<bool> &truth) {
  return !truth ? "" : *truth ? "true" : "false";
}

std::string columns(const std::optional<Real> &y) {
  if (!y)
    return ",";
  const Enclosure e = enclose(*y, digits);
  return e.lower_text() + "," + e.upper_text();
}

/// Distance of neighbours, for marks that touch.
double least_step(const std::vector<Rational> &values) {
  double step = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double next = to_double(Rational(values[i] - values[i - 1]));
    step = step == 0 ? next : std::min(step, next);
  }
  return step == 0 ? 1 : step;
}

Axis value_axis(const std::string &title, const std::vector<Rational> &values) {
  const double half = least_step(values) / 2;
  Axis axis = linear_axis(title, to_double(values.front()) - half, to_double(values.back()) + half);
  axis.low = std::max(axis.low, to_double(values.front()) - half);
  axis.high = std::min(axis.high, to_double(values.back()) + half);
  axis.ticks.erase(std::remove_if(axis.ticks.begin(), axis.ticks.end(),
                                  [&](const Tick &t) { return t.at < axis.low || t.at > axis.high; }),
                   axis.ticks.end());
  return axis;
}

constexpr double map_size = 330;

Series cells(const AccessibleQuestion &q) {
  constexpr double points_of_mark = 6.2; // about, with pointsize 1
  Series series;
  series.stroke = Stroke::none;
  series.mark = Mark::square;
  const double across = map_size / (to_double(Rational(q.a.back() - q.a.front())) / least_step(q.a) + 1);
  const double up = map_size / (to_double(Rational(q.b.back() - q.b.front())) / least_step(q.b) + 1);
  series.mark_size = std::clamp(std::min(across, up) / points_of_mark, 0.2, 12.0);
  return series;
}

/// One way of making sets.
struct Way {
  const char *title;
  std::optional<bool> AccessibleRow::*accessible;
  std::optional<Integer> AccessibleRow::*particles;
};
constexpr std::array<Way, 2> ways = {
    {{"Eq. 6-9", &AccessibleRow::paper_accessible, &AccessibleRow::paper},
     {"smallest match", &AccessibleRow::match_accessible, &AccessibleRow::match}}};

Panel map_panel(const AccessibleQuestion &q, const Rows &rows, const Way &way, Range &values) {
  Panel panel;
  panel.title = fmt::format("s = {}, {}", to_decimal(rows.front().span), way.title);
  panel.x = value_axis("a", q.a);
  panel.y = value_axis("b", q.b);
  Series in = cells(q), out = cells(q), open = cells(q);
  in.by_value = true;
  out.color = "#f4d9c6";
  out.title = "not accessible";
  open.color = "#999999";
  open.title = "not decided";
  for (const AccessibleRow &row : rows) {
    Point at{to_double(row.shape.a), to_double(row.shape.b)};
    if (row.*way.accessible == true && row.*way.particles) {
      at.value = log10_of(Rational(*(row.*way.particles)));
      values.cover(at.value);
      in.points.push_back(at);
    } else {
      (row.*way.accessible == false ? out : open).points.push_back(at);
    }
  }
  for (Series &series : std::array<Series, 3>{std::move(in), std::move(out), std::move(open)})
    if (!series.points.empty())
      panel.series.push_back(std::move(series));
  return panel;
}

/// The least and the greatest C_u of accessible shapes.
Panel reach_panel(const AccessibleQuestion &q, const Rows &rows) {
  Panel panel;
  panel.title = "C_u of accessible shapes";
  panel.grid = true;
  Range all;
  constexpr std::array<const char *, 2> colors = {"#1f4e79", "#c55a11"};
  for (std::size_t w = 0; w < ways.size(); ++w) {
    Series low, high;
    high.title = ways.at(w).title;
    low.color = high.color = colors.at(w);
    high.stroke = low.stroke = w == 0 ? Stroke::solid : Stroke::dashed;
    low.mark = high.mark = Mark::disc;
    for (std::size_t i = 0; i < q.spans.size(); ++i) {
      Range range;
      for (const AccessibleRow &row : rows_of_span(q, rows, i))
        if (row.*ways.at(w).accessible == true && row.c_u)
          range.cover(log10_of(enclose(*row.c_u, digits).lower()));
      if (range.empty())
        continue;
      low.points.push_back({to_double(q.spans[i]), range.low});
      high.points.push_back({to_double(q.spans[i]), range.high});
      all.cover(range.low);
      all.cover(range.high);
    }
    if (!low.points.empty())
      panel.series.insert(panel.series.end(), {low, high});
  }
  panel.x = linear_axis("size span s", 0, 1);
  panel.y = decades_axis("C_u, least and greatest", all);
  return panel;
}

} // namespace

std::vector<std::string> undecided(const Rows &rows) {
  struct Reason {
    const AccessibleRow *first;
    std::size_t shapes;
  };
  std::map<std::string, Reason> reasons;
  for (const AccessibleRow &row : rows)
    if (!is_decided(row))
      ++reasons.try_emplace(row.why, Reason{&row, 0}).first->second.shapes;
  std::vector<std::string> lines;
  for (const auto &[why, reason] : reasons)
    lines.push_back(
        fmt::format("{} not decided (?), the first s = {}, a = {}, b = {}: {}",
                    reason.shapes == 1 ? "1 shape is" : std::to_string(reason.shapes) + " shapes are",
                    to_decimal(reason.first->span), to_decimal(reason.first->shape.a),
                    to_decimal(reason.first->shape.b), why));
  return lines;
}

std::string accessible_text(const AccessibleQuestion &q, const Rows &rows) {
  std::string text = "accessible shapes (a, b) of the beta curve\n  " + terms(q) + "\n";
  for (std::size_t i = 0; i < q.spans.size(); ++i) {
    const Rows some = rows_of_span(q, rows, i);
    text += fmt::format("\n  s = {}: {} of {} by Eq. 6-9 (P), {} by the smallest match (M), both: B\n",
                        to_decimal(q.spans[i]), count(some, &AccessibleRow::paper_accessible), some.size(),
                        count(some, &AccessibleRow::match_accessible));
    text += letters(q, some);
  }
  for (const std::string &line : undecided(rows))
    text += "  note: " + line + "\n";
  return text;
}

std::string accessible_json(const AccessibleQuestion &q, const Rows &rows) {
  const auto enclosed = [](const std::optional<Real> &y) {
    return y ? std::optional(enclose(*y, digits)) : std::nullopt;
  };
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-accessible-1").key("question").string(terms(q));
  json.key("shapes").begin_array();
  for (const AccessibleRow &row : rows) {
    json.begin_object().key("span").plain(to_decimal(row.span));
    json.key("a").plain(to_decimal(row.shape.a)).key("b").plain(to_decimal(row.shape.b));
    write(json.key("paper").begin_object().key("particles"), row.paper);
    write_truth(json.key("accessible"), row.paper_accessible).end_object();
    write(json.key("match").begin_object().key("particles"), row.match);
    write_truth(json.key("accessible"), row.match_accessible).end_object();
    write(json.key("Cu"), enclosed(row.c_u));
    write(json.key("Cc"), enclosed(row.c_c));
    write_text(json.key("note"), row.why).end_object();
  }
  json.end_array().key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string accessible_csv(const Rows &rows) {
  std::string text = "span,a,b,paper_particles,paper_accessible,match_particles,match_accessible,Cu_lo,Cu_hi,"
                     "Cc_lo,Cc_hi\n";
  for (const AccessibleRow &row : rows)
    text += fmt::format("{},{},{},{},{},{},{},{},{}\n", to_decimal(row.span), to_decimal(row.shape.a),
                        to_decimal(row.shape.b), field(row.paper), field(row.paper_accessible),
                        field(row.match), field(row.match_accessible), columns(row.c_u), columns(row.c_c));
  return text;
}

Figure accessible_map(const AccessibleQuestion &q, const Rows &rows) {
  Figure figure;
  figure.title = "Accessible shapes: " + terms(q);
  figure.columns = 2;
  figure.panel_width = figure.panel_height = map_size;
  Range values;
  for (std::size_t i = 0; i < q.spans.size(); ++i)
    for (const Way &way : ways)
      figure.panels.push_back(map_panel(q, rows_of_span(q, rows, i), way, values));
  if (q.spans.size() > 1)
    figure.panels.push_back(reach_panel(q, rows));
  if (!values.empty())
    figure.colors = linear_axis("log10 of the number of particles", values.low, values.high);
  return figure;
}

} // namespace mdm
