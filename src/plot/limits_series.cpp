#include "plot/limits_series.hpp"

#include <algorithm>
#include <iterator>

namespace mdm {
namespace {

Series edge_of_limits(std::vector<Point> points) {
  Series s;
  s.points = std::move(points);
  s.color = "#38761d";
  s.width = 0.75;
  return s;
}

} // namespace

std::vector<Series> limits_series(const Envelope &limits, const Rational &unit_mm, const std::string &title) {
  std::vector<Point> least, most;
  for (std::size_t i = 0; i < limits.sizes.size(); ++i) {
    if (limits.sizes[i] == 0)
      continue;
    const double at = log10_of(Rational(limits.sizes[i] * in_mm(limits.unit) / unit_mm));
    least.push_back({at, limits.passing_min[i].convert_to<double>()});
    most.push_back({at, limits.passing_max[i].convert_to<double>()});
  }
  Series inside;
  inside.points = least;
  std::copy(most.rbegin(), most.rend(), std::back_inserter(inside.points));
  inside.title = title;
  inside.color = "#d9ead3";
  inside.width = 0.75;
  inside.filled = true;
  return {inside, edge_of_limits(least), edge_of_limits(most)};
}

} // namespace mdm
