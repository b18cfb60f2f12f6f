#include "plot/packing_figure.hpp"

#include "number/real.hpp"
#include "packing/contacts.hpp"
#include "packing/packing_fraction.hpp"
#include "packing/packing_writer.hpp"
#include "plot/size_colors.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

namespace mdm {
namespace {

constexpr const char *circle_color = "#8c8c8c";

/// Things of one colour and how they are called.
struct Kind {
  std::string title;
  const char *color;
  std::uint64_t count = 0; ///< in the packing, however much of it is shown
  Series series = {};
};

class PackingDrawing {
public:
  PackingDrawing(const Packing &packing, const PackingView &view) : p_(packing), view_(view) {
    for (unsigned i = 0; i < p_.places; ++i)
      unit_ /= 10;
    width_ = length(p_.width);
    for (const PackedDisc &d : p_.discs)
      top_ = std::max(top_, length(d.y + d.r));
    if (is_gasket())
      top_ = width_;
    top_ = std::max(std::min(top_, view.most_high * width_), view.least_high * width_);
  }

  Panel panel() {
    Panel panel;
    const std::string in = p_.unit.empty() ? "" : " (" + p_.unit + ")";
    const double margin = is_gasket() ? 0.01 * width_ : 0;
    panel.x = axis("x" + in, -margin, width_ + margin);
    panel.y = axis((is_gasket() ? "y" : "height") + in, -margin, top_ + margin);
    if (is_gasket())
      panel.series.push_back(outer_circle());
    std::vector<Kind> kinds = view_.colour == PackingColour::size       ? by_size()
                              : view_.colour == PackingColour::contacts ? by_contacts()
                                                                        : by_cells();
    for (Kind &k : kinds)
      if (k.count > 0)
        panel.series.push_back(titled(std::move(k)));
    if (view_.colour == PackingColour::cells)
      panel.series.push_back(circles());
    return panel;
  }

private:
  bool is_gasket() const { return p_.rule == DepositRule::apollonian; }
  double length(std::int64_t units) const { return static_cast<double>(units) * unit_; }

  static Axis axis(const std::string &title, double low, double high) {
    Axis axis = linear_axis(title, std::max(low, 0.0), high);
    axis.low = low;
    axis.high = high;
    axis.ticks.erase(
        std::remove_if(axis.ticks.begin(), axis.ticks.end(), [&](const Tick &t) { return t.at > high; }),
        axis.ticks.end());
    return axis;
  }

  Series titled(Kind k) const {
    const char *const thing = view_.colour == PackingColour::cells ? "cell" : "disc";
    k.series.title =
        view_.counts ? fmt::format("{}: {} {}{}", k.title, k.count, thing, k.count == 1 ? "" : "s") : k.title;
    k.series.color = k.color;
    k.series.filled = true;
    k.series.discs = view_.colour != PackingColour::cells;
    k.series.edge = k.series.discs ? edge_color : "";
    k.series.width = edge_width();
    return std::move(k.series);
  }

  /// A line between discs that leaves small ones their colour.
  double edge_width() const {
    constexpr double widest = 0.5, part = 0.03, usual_panel = 560; // pt
    const double mean = std::sqrt(width_ * top_ / static_cast<double>(p_.discs.size()));
    return std::min(widest, part * mean / width_ * usual_panel);
  }

  /// A disc with the images of it that are in the box.
  void add_disc(Series &series, const PackedDisc &d) const {
    const double r = length(d.r), y = length(d.y);
    for (const int shift : {-1, 0, 1}) {
      const double x = length(d.x) + shift * width_;
      if ((shift == 0 || p_.periodic) && x + r > 0 && x - r < width_ && y - r < top_)
        series.points.push_back({x, y, 0, r});
    }
  }

  Series circles() const {
    Series series;
    series.color = circle_color;
    series.discs = true;
    series.width = edge_width();
    for (const PackedDisc &d : p_.discs)
      add_disc(series, d);
    return series;
  }

  Series outer_circle() const {
    Series series;
    series.color = edge_color;
    series.discs = true;
    series.width = 1;
    series.points.push_back({width_ / 2, width_ / 2, 0, width_ / 2});
    return series;
  }

  /// Ranges of the diameter with one ratio of their ends.
  std::vector<Kind> by_size() const {
    const auto [least, greatest] = std::minmax_element(
        p_.discs.begin(), p_.discs.end(), [](const PackedDisc &a, const PackedDisc &b) { return a.r < b.r; });
    const double smallest = 2 * length(least->r), largest = 2 * length(greatest->r);
    if (least->r == greatest->r) {
      std::vector<Kind> all = {{fmt::format("{:.6g}", smallest), size_colors[3]}};
      for (const PackedDisc &d : p_.discs)
        add(all.front(), d);
      return all;
    }
    const std::vector<std::string> ends = size_texts(smallest, largest);
    std::vector<Kind> all;
    for (std::size_t i = 0; i < size_colors.size(); ++i)
      all.push_back({ends[i] + " to " + ends[i + 1], size_colors.at(i)});
    const double step = std::log(largest / smallest) / static_cast<double>(size_colors.size());
    for (const PackedDisc &d : p_.discs) {
      const double at = std::log(2 * length(d.r) / smallest) / step;
      add(all[std::min(static_cast<std::size_t>(std::max(at, 0.0)), all.size() - 1)], d);
    }
    return all;
  }

  /// The ends of ranges with as many digits as tell them apart.
  static std::vector<std::string> size_texts(double smallest, double largest) {
    std::vector<std::string> texts;
    for (int digits = 3; digits < 15; ++digits) {
      texts.clear();
      for (std::size_t i = 0; i <= size_colors.size(); ++i)
        texts.push_back(
            fmt::format("{:.{}g}",
                        smallest * std::pow(largest / smallest,
                                            static_cast<double>(i) / static_cast<double>(size_colors.size())),
                        digits));
      if (std::set<std::string>(texts.begin(), texts.end()).size() == texts.size())
        break;
    }
    return texts;
  }

  std::vector<Kind> by_contacts() const {
    const PackingContacts contacts = packing_contacts(p_);
    std::vector<Kind> all = {{"touches 2 others or fewer", size_colors[0]},
                             {"touches 3 others", size_colors[2]},
                             {"touches 4 others", size_colors[3]},
                             {"touches 5 others", size_colors[5]},
                             {"touches 6 others or more", size_colors[7]}};
    constexpr std::uint32_t least = 2;
    for (std::size_t i = 0; i < p_.discs.size(); ++i) {
      const std::size_t more = std::max(contacts.of_disc[i], least) - least;
      add(all[std::min(more, all.size() - 1)], p_.discs[i]);
    }
    return all;
  }

  std::vector<Kind> by_cells() const {
    constexpr std::size_t triangle = 3, quadrangle = 4;
    std::vector<Kind> all = {
        {"triangles", "#c55a11"}, {"quadrangles", "#bdd7ee"}, {"five corners or more", "#595959"}};
    each_cell(p_, packing_contacts(p_), [&](const std::vector<CellCorner> &corners) {
      Kind &kind = all.at(corners.size() == triangle ? 0 : corners.size() == quadrangle ? 1 : 2);
      ++kind.count;
      add_cell(kind.series, corners);
    });
    return all;
  }

  void add(Kind &kind, const PackedDisc &d) const {
    ++kind.count;
    add_disc(kind.series, d);
  }

  /// A cell with the images of it that are in the box.
  void add_cell(Series &series, const std::vector<CellCorner> &corners) const {
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    const auto [left, right] = std::minmax_element(
        corners.begin(), corners.end(), [](const CellCorner &a, const CellCorner &b) { return a.x < b.x; });
    const auto lowest = std::min_element(corners.begin(), corners.end(),
                                         [](const CellCorner &a, const CellCorner &b) { return a.y < b.y; });
    const double from = p_.periodic ? -std::floor(length(right->x) / width_) : 0;
    const double to = p_.periodic ? from + std::ceil(length(right->x - left->x) / width_) : 0;
    if (length(lowest->y) >= top_)
      return;
    for (double shift = from; shift <= to; ++shift) {
      for (const CellCorner &c : corners)
        series.points.push_back({length(c.x) + shift * width_, length(c.y)});
      series.points.push_back({gap, gap});
    }
  }

  const Packing &p_;
  PackingView view_;
  double unit_ = 1; ///< of the lattice
  double width_ = 0, top_ = 0;
};

std::vector<std::string> notes(const Packing &p) {
  if (p.rule == DepositRule::apollonian)
    return {"", "Apollonian packing in the circle drawn"};
  std::vector<std::string> all = {
      "", fmt::format("rule {}, floor {}, seed {}", name(p.rule), name(p.floor), p.seed),
      p.periodic ? "both sides are one: discs cut there" : "walls on both sides"};
  if (p.periodic)
    all.emplace_back("on one side go on at the other");
  if (const PackingWindow window = p.inner_window(); !window.is_empty())
    all.push_back("packing fraction " + rounded(packing_fraction(p, window), 6));
  return all;
}

} // namespace

Panel packing_panel(const Packing &packing, const PackingView &view) {
  return PackingDrawing(packing, view).panel();
}

Figure packing_figure(const Packing &packing, PackingColour colour) {
  constexpr double usual = 560, highest = 900; // pt
  PackingView view;
  view.colour = colour;
  // The legend has room beside it.
  view.least_high = 0.5;
  Figure figure;
  figure.panels.push_back(packing_panel(packing, view));
  const Panel &panel = figure.panels.front();
  const double slope = panel.y.span() / panel.x.span();
  figure.panel_height = std::min(usual * slope, highest);
  figure.panel_width = figure.panel_height / slope;
  const std::string unit = packing.unit.empty() ? "" : " (" + packing.unit + ")";
  const std::string discs = std::to_string(packing.discs.size()) +
                            (packing.rule == DepositRule::apollonian ? " circles" : " discs");
  figure.title = colour == PackingColour::size ? discs + " by their diameter" + unit
                 : colour == PackingColour::contacts
                     ? discs + " by the number of others that they touch"
                     : "Cells between " + discs + " that touch, by their corners";
  figure.notes = notes(packing);
  return figure;
}

} // namespace mdm
