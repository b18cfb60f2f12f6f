#include "papers/inverse_report.hpp"

#include "answer/json_values.hpp"
#include "plot/ranges.hpp"
#include "text/text_table.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr unsigned box_places = 8;

/// Decimals around y.
std::pair<std::string, std::string> around(const Interval &y) {
  const Rational unit(power_of_ten(box_places));
  return {decimal_string(floor(Rational(y.lo * unit)), box_places),
          decimal_string(ceil(Rational(y.hi * unit)), box_places)};
}

std::string span_text_of(const InverseRow &row) {
  return exact_decimal(row.span).value_or(to_string(row.span));
}

std::string range_around(const Interval &y) {
  const auto [lo, hi] = around(y);
  return "[" + lo + ", " + hi + "]";
}

/// What is certain of a box.
const char *certainty(const ShapeBox &box) {
  return box.holds_one ? "one or more" : "not certain";
}

std::string verdict_of(const InverseShapes &shapes) {
  if (!shapes.complete)
    return "the search stopped at its limit";
  if (shapes.boxes.empty())
    return "none";
  std::size_t proved = 0;
  for (const ShapeBox &box : shapes.boxes)
    proved += box.holds_one ? 1U : 0U;
  return proved > 1 ? fmt::format("several: {} at least", proved) : "";
}

std::string range_of_search(const InverseTask &task) {
  return fmt::format("{} to {}", to_decimal(task.within.lo), to_decimal(task.within.hi));
}

void write_range(JsonWriter &json, const Interval &y) {
  const auto [lo, hi] = around(y);
  json.begin_array().plain(lo).plain(hi).end_array();
}

} // namespace

std::string inverse_text(const InverseTask &task, const std::vector<InverseRow> &rows) {
  std::string text = fmt::format(
      "shapes (a, b) of the beta curve with {}\n"
      "  a and b from {}; at a span every such shape lies in a box of its lines; that a box has one "
      "alone is not proved\n\n",
      task.what, range_of_search(task));
  TextTable table;
  for (const char *title : {"span", "shapes", "a", "b", "at this span"})
    table.add_column(title, '<');
  for (const InverseRow &row : rows) {
    const std::string verdict = verdict_of(row.shapes);
    std::size_t i = 0;
    do {
      table.add_line();
      table.add(span_text_of(row));
      const bool has_box = i < row.shapes.boxes.size();
      table.add(has_box ? certainty(row.shapes.boxes[i]) : "none");
      table.add(has_box ? range_around(row.shapes.boxes[i].a) : "-");
      table.add(has_box ? range_around(row.shapes.boxes[i].b) : "-");
      table.add(i == 0 ? verdict : "");
    } while (++i < row.shapes.boxes.size());
  }
  text += table.text();
  for (const std::string &note : task.notes)
    text += "  note: " + note + "\n";
  return text;
}

std::string inverse_json(const InverseTask &task, const std::vector<InverseRow> &rows) {
  JsonWriter json;
  json.begin_object().key("schema").plain("mdm-inverse-1").key("question").string(task.what);
  write_range(json.key("Cu"), task.c_u);
  write_range(json.key("Cc"), task.c_c);
  write_range(json.key("within"), task.within);
  json.key("spans").begin_array();
  for (const InverseRow &row : rows) {
    json.begin_object().key("span").plain(span_text_of(row)).key("complete").boolean(row.shapes.complete);
    json.key("boxes").begin_array();
    for (const ShapeBox &box : row.shapes.boxes) {
      write_range(json.begin_object().key("a"), box.a);
      write_range(json.key("b"), box.b);
      json.key("holds_one").boolean(box.holds_one).end_object();
    }
    json.end_array().end_object();
  }
  json.end_array().key("notes").strings(task.notes).key("versions").raw(versions_json()).end_object();
  return json.take();
}

std::string inverse_csv(const std::vector<InverseRow> &rows) {
  std::string text = "span,a_lo,a_hi,b_lo,b_hi,shapes\n";
  for (const InverseRow &row : rows) {
    for (const ShapeBox &box : row.shapes.boxes) {
      const auto [a_lo, a_hi] = around(box.a);
      const auto [b_lo, b_hi] = around(box.b);
      text += fmt::format("{},{},{},{},{},{}\n", span_text_of(row), a_lo, a_hi, b_lo, b_hi, certainty(box));
    }
    if (row.shapes.boxes.empty())
      text += span_text_of(row) + ",,,,,none\n";
  }
  return text;
}

Figure inverse_map(const InverseTask &task, const std::vector<InverseRow> &rows) {
  Series certain, open;
  certain.stroke = open.stroke = Stroke::none;
  certain.mark = Mark::disc;
  open.mark = Mark::ring;
  certain.by_value = open.by_value = true;
  Range spans;
  for (const InverseRow &row : rows)
    for (const ShapeBox &box : row.shapes.boxes) {
      const auto middle = [](const Interval &y) { return log10_of(Rational((y.lo + y.hi) / 2)); };
      const Point at{middle(box.a), middle(box.b), to_double(row.span)};
      (box.holds_one ? certain : open).points.push_back(at);
      spans.cover(at.value);
    }
  Panel panel;
  panel.title = "a and b from " + range_of_search(task);
  panel.grid = true;
  panel.x = log_axis("a", log10_of(task.within.lo), log10_of(task.within.hi));
  panel.y = log_axis("b", log10_of(task.within.lo), log10_of(task.within.hi));
  panel.series = {std::move(certain), std::move(open)};
  Figure figure;
  figure.title = "Shapes with " + task.what;
  figure.panel_width = figure.panel_height = 420;
  if (!spans.empty())
    figure.colors = linear_axis("size span s", spans.low, spans.high);
  figure.notes = {"A disc is a box in which a shape is proved,", "a ring one in which that is not certain.",
                  "At the other spans there is none."};
  figure.panels.push_back(std::move(panel));
  return figure;
}

} // namespace mdm
