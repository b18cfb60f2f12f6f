#include "plot/section_figure.hpp"

#include "plot/ranges.hpp"
#include "plot/size_colors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace mdm {
namespace {

constexpr const char *outside_color = "#d0d0d0";

/// The color of class j of n, from light for the finest to dark: each class has its own.
std::string color_of_class(std::size_t j, std::size_t n) {
  const double last = static_cast<double>(size_colors.size() - 1);
  const double at = n < 2 ? last / 2 : last * static_cast<double>(j) / static_cast<double>(n - 1);
  const auto first = std::min(static_cast<std::size_t>(at), size_colors.size() - 2);
  std::string color = "#";
  for (const std::size_t part : {1U, 3U, 5U}) { // red, green and blue
    const auto value = [&](std::size_t i) {
      return std::stoi(std::string(size_colors.at(i)).substr(part, 2), nullptr, 16);
    };
    const double mixed = value(first) + (at - static_cast<double>(first)) * (value(first + 1) - value(first));
    color += fmt::format("{:02x}", std::lround(mixed));
  }
  return color;
}

/// The circle in which a plane y = `at` cuts sphere i; nothing where it does not.
std::optional<Point> cut(const SphereSample &sample, std::size_t i, double at) {
  const double off = sample.centre(i)[1] - at, r = sample.radius(i), rest = r * r - off * off;
  if (!(rest > 0))
    return std::nullopt;
  return Point{sample.centre(i)[0], sample.centre(i)[2], 0, std::sqrt(rest)};
}

/// An axis of just this stretch, with the ticks that lie on it.
Axis exact_axis(const std::string &title, double low, double high) {
  Axis axis = linear_axis(title, low, high);
  axis.low = low;
  axis.high = high;
  std::erase_if(axis.ticks, [&](const Tick &t) { return t.at < low || t.at > high; });
  return axis;
}

/// Series for all classes from the coarsest, so that the legend begins with it, and for what is in none.
std::vector<Series> series_of(const Gradation &g) {
  std::vector<Series> all(g.classes() + 1);
  for (std::size_t j = 0; j < g.classes(); ++j) {
    all[j].title = fmt::format("{} to {} {}", g.opening_text(j), g.opening_text(j + 1), name(g.unit()));
    all[j].color = color_of_class(j, g.classes());
  }
  all.back().title = "outside all classes";
  all.back().color = outside_color;
  for (Series &series : all) {
    series.filled = true;
    series.discs = true;
    series.edge = edge_color;
    series.width = 0.4;
  }
  return all;
}

} // namespace

Panel section_panel(const SphereSample &sample, const Gradation &g, double slope) {
  Range across, along, up;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    const std::array<double, 3> &c = sample.centre(i);
    const double r = sample.radius(i);
    for (const double end : {-r, r}) {
      across.cover(c[0] + end);
      up.cover(c[2] + end);
    }
    along.cover(c[1]);
  }
  const double plane = (along.low + along.high) / 2;
  std::vector<Series> all = series_of(g);
  for (std::size_t i = 0; i < sample.size(); ++i)
    if (const std::optional<Point> circle = cut(sample, i, plane))
      all[std::min<std::size_t>(sample.group(i), g.classes())].points.push_back(*circle);

  // The panel has the grains in its middle, above the floor.
  constexpr double room = 1.04;
  const double width = room * std::max(across.high - across.low, (up.high - up.low) / slope);
  const double middle = (across.low + across.high) / 2, margin = (room - 1) / 2 * (up.high - up.low);
  Panel panel;
  const std::string in = fmt::format(" ({})", name(g.unit()));
  panel.title = fmt::format("section at y = {:.4g} {}", plane, name(g.unit()));
  panel.x = exact_axis("x" + in, middle - width / 2, middle + width / 2);
  panel.y = exact_axis("z" + in, up.low - margin, up.low - margin + width * slope);
  for (auto series = all.rbegin(); series != all.rend(); ++series)
    if (!series->points.empty())
      panel.series.push_back(std::move(*series));
  return panel;
}

} // namespace mdm
