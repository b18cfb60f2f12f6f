#include "papers/packing_figures.hpp"

#include "papers/shape_lines.hpp"
#include "plot/packing_figure.hpp"

namespace mdm {
namespace {

constexpr double snapshot_width = 470; // pt

/// A line of each shape, told apart by its marks too.
std::vector<Series> fraction_lines(const PackingStudy &study, Classing classing) {
  static constexpr std::array<Mark, 5> marks = {Mark::disc, Mark::square, Mark::triangle, Mark::diamond,
                                                Mark::ring};
  std::vector<Series> lines = shape_lines(
      study.points, [](const PackingPoint &p) { return p.shape; },
      [classing](const PackingPoint &p) { return p.classing == classing && !p.deposits.empty(); },
      [](const PackingPoint &p) {
        return Point{to_double(p.span), to_double(p.mean().lo)};
      });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].mark = marks.at(i % marks.size());
    lines[i].mark_size = 0.8;
    lines[i].stroke = i < marks.size() ? Stroke::solid : Stroke::dashed;
  }
  return lines;
}

/// From the smallest to the largest packing fraction of a point's deposits.
std::vector<Series> range_bars(const PackingStudy &study, Classing classing) {
  std::vector<Series> bars = shape_lines(
      study.points, [](const PackingPoint &p) { return p.shape; }, [](const PackingPoint &) { return false; },
      [](const PackingPoint &) { return Point{}; });
  for (const PackingPoint &p : study.points) {
    if (p.classing != classing || p.deposits.empty())
      continue;
    Range range;
    for (const DepositFacts &d : p.deposits)
      range.cover(to_double(d.fraction.lo));
    const auto bar = std::find_if(bars.begin(), bars.end(),
                                  [&p](const Series &s) { return s.title == shape_title(p.shape); });
    const double x = to_double(p.span);
    bar->points.insert(bar->points.end(), {{x, range.low}, {x, range.high}, {no_number, no_number}});
  }
  for (Series &bar : bars) {
    bar.title.clear();
    bar.width = 1;
  }
  return bars;
}

Panel fraction_panel(const PackingStudy &study, Classing classing) {
  Panel panel = lines_panel(range_bars(study, classing));
  for (Series &line : fraction_lines(study, classing))
    panel.series.push_back(std::move(line));
  panel.title = classing == Classing::regular ? "regular classes" : "geometric classes";
  panel.x = linear_axis("size span s", 0, 1);
  return panel;
}

/// As high as wide, at most.
Panel snapshot_panel(const Snapshot &s, PackingColour colour) {
  PackingView view;
  view.colour = colour;
  view.counts = false;
  view.most_high = 1;
  Panel panel = packing_panel(s.packing, view);
  panel.x.title = "x / d_min";
  panel.y.title = "height / d_min";
  return panel;
}

/// Panels of square boxes, cut where the lowest of them ends.
Figure snapshot_figure(std::vector<Panel> panels) {
  double slope = 1;
  for (const Panel &p : panels)
    slope = std::min(slope, p.y.span() / p.x.span());
  for (Panel &p : panels)
    p.y.high = p.y.low + slope * p.x.span();
  Figure figure;
  figure.columns = panels.size();
  figure.panel_width = snapshot_width;
  figure.panel_height = slope * snapshot_width;
  figure.panels = std::move(panels);
  return figure;
}

std::string discs_text(const Snapshot &s) {
  return std::to_string(s.packing.discs.size()) + " discs";
}

} // namespace

Figure gasket_figure(const Packing &gasket, const Rational &most) {
  Figure figure = packing_figure(gasket, PackingColour::size);
  figure.title = "Apollonian packing around three circles of radius 1, " +
                 std::to_string(gasket.discs.size()) + " circles";
  figure.notes.push_back("down to radius 1/" + to_decimal(most) + ", by their diameter");
  return figure;
}

Figure fraction_figure(const PackingStudy &study) {
  Figure figure;
  figure.title = "Packing fraction over the size span, by the rule of the lowest place";
  figure.columns = 2;
  figure.panel_width = 430;
  figure.panels = {fraction_panel(study, Classing::geometric), fraction_panel(study, Classing::regular)};
  Range range;
  for (const Panel &p : figure.panels)
    range.cover(range_of(p.series, &Point::y));
  for (Panel &p : figure.panels) {
    constexpr double hundredths = 100;
    p.y = plain_axis("packing fraction", range);
    p.y.low = std::max(p.y.low, std::floor(range.low * hundredths) / hundredths);
    p.y.high = std::min(p.y.high, std::ceil(range.high * hundredths) / hundredths);
  }
  std::size_t seeds = 0;
  for (const PackingPoint &p : study.points)
    seeds = std::max(seeds, p.deposits.size());
  figure.notes = {fmt::format("mean of {} deposit{}", seeds, seeds == 1 ? "" : "s"),
                  "in boxes of several widths,", "bars from the smallest to the largest;",
                  "N_min = " + to_string(study.terms.at_least) +
                      ", N_max = " + to_string(study.terms.at_most)};
  return figure;
}

Figure regions_figure(const Snapshot &s) {
  Panel discs = snapshot_panel(s, PackingColour::contacts), regions = snapshot_panel(s, PackingColour::cells);
  discs.title = "(a) the discs";
  regions.title = "(b) regions: triangular, rectangular, random";
  for (Series &series : regions.series)
    if (!series.title.empty())
      series.title = series.title == "triangles"     ? "A: cells with 3 corners"
                     : series.title == "quadrangles" ? "B: cells with 4 corners"
                                                     : "C: cells with more corners";
  Figure figure = snapshot_figure({std::move(discs), std::move(regions)});
  figure.title = fmt::format("A nearly monodisperse packing, s = {}, {}", to_decimal(s.span), discs_text(s));
  return figure;
}

Figure snapshots_figure(const std::vector<Snapshot> &snapshots) {
  std::vector<Panel> panels;
  for (const Snapshot &s : snapshots) {
    panels.push_back(snapshot_panel(s, PackingColour::contacts));
    panels.back().title = fmt::format("s = {}, {}", to_decimal(s.span), discs_text(s));
  }
  Figure figure = snapshot_figure(std::move(panels));
  figure.title = "Packings of discs that are uniform by volume, a = b = 1";
  return figure;
}

} // namespace mdm
