#pragma once
/// \file
/// Lines of the shapes of the beta model, in the figures of Voivret, Delenne and Radjai.

#include "papers/size_models.hpp"
#include "plot/ranges.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {

/// Of the shapes, in the order in which they come.
inline constexpr std::array<const char *, 7> shape_colors = {"#1f4e79", "#c55a11", "#3a7d44", "#7b3f98",
                                                             "#b8860b", "#c0392b", "#555555"};

inline std::string shape_title(const Shape &shape) {
  return fmt::format("a = {}, b = {}", to_decimal(shape.a), to_decimal(shape.b));
}

inline bool same_shape(const Shape &x, const Shape &y) {
  return x.a == y.a && x.b == y.b;
}

/// Lines of the rows' shapes, each its colour, in the order in which they come. \param belongs whether a row
/// is a point of them \param point of a row
template <class Row, class Shaped, class Belongs, class PointOf>
std::vector<Series> shape_lines(const std::vector<Row> &rows, Shaped shape, Belongs belongs, PointOf point) {
  std::vector<Series> lines;
  std::vector<Shape> shapes;
  for (const Row &row : rows) {
    const auto at =
        std::find_if(shapes.begin(), shapes.end(), [&](const Shape &s) { return same_shape(s, shape(row)); });
    const auto i = static_cast<std::size_t>(at - shapes.begin());
    if (at == shapes.end()) {
      shapes.push_back(shape(row));
      lines.emplace_back();
      lines.back().title = shape_title(shape(row));
      lines.back().color = shape_colors.at(i % shape_colors.size());
    }
    if (belongs(row))
      lines[i].points.push_back(point(row));
  }
  return lines;
}

inline Range range_of(const std::vector<Series> &lines, double Point::*coordinate) {
  Range range;
  for (const Series &line : lines)
    for (const Point &p : line.points)
      if (!std::isnan(p.*coordinate))
        range.cover(p.*coordinate);
  return range;
}

inline Panel lines_panel(std::vector<Series> lines) {
  Panel panel;
  panel.grid = true;
  panel.series = std::move(lines);
  return panel;
}

} // namespace mdm
