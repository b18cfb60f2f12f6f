#include "plot/gradation_figure.hpp"

#include "gradation/sieve_name.hpp"
#include "plot/figure_layout.hpp"
#include "plot/limits_series.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace mdm {
namespace {

constexpr const char *curve_color = "#1f4e79";
constexpr const char *set_color = "#c0392b";
constexpr const char *mark_color = "#555555";
constexpr const char *band_color = "#f6f2e8";

double percent(const Rational &share) {
  return 100 * share.convert_to<double>();
}

/// n in full, or its first digits where it is long.
std::string count_text(const Integer &n) {
  constexpr std::size_t longest = 12;
  const std::string digits = to_string(n);
  if (digits.size() <= longest)
    return digits;
  return fmt::format("{}.{}e{}", digits.substr(0, 1), digits.substr(1, 3), digits.size() - 1);
}

/// An opening as a label.
std::string length_text(const Rational &r) {
  constexpr std::size_t longest = 9;
  const std::optional<std::string> exact = exact_decimal(r);
  if (exact && exact->size() <= longest)
    return *exact;
  const Integer whole = floor(r);
  return whole >= 10000 ? count_text(whole) : approximate(r, 4);
}

class Drawing {
public:
  Drawing(const Gradation &g, const GradationFigure &what)
      : g_(g), what_(what), soil_(describe(g, what.soil)), curve_(soil_.curve), unit_mm_(in_mm(g.unit())),
        unit_(name(g.unit())), texts_(figure_texts(what.form.language)) {
    for (std::size_t i = 0; i < curve_.shares().size(); ++i)
      sizes_.push_back(drawn_size(curve_.opening(i)));
  }

  Figure figure() {
    constexpr double half_height = 290; // of two panels in a figure
    constexpr double least_height = 210;
    Figure figure;
    if (what_.curve && what_.counts)
      figure.panel_height = half_height;
    if (what_.form.width > 0) {
      // What stands beside the panels is known when they are drawn, and is the same at any width.
      const Figure usual = drawn(figure);
      figure.panel_width = panel_width_in(what_.form.width, usual);
      figure.panel_height = std::min(figure.panel_height, std::max(least_height, 0.42 * what_.form.width));
    }
    return drawn(figure);
  }

private:
  /// The figure in the form of an empty one.
  Figure drawn(Figure figure) {
    figure.title = g_.id();
    figure.description = what_.curve ? texts_.passing_shown : texts_.counts_shown;
    figure.bare = what_.form.bare;
    figure.remarks = g_.notes();
    width_ = figure.panel_width;
    height_ = figure.panel_height;
    set_x();
    if (what_.curve) {
      figure.panels.push_back(curve_panel());
      add_description(figure.notes);
      const std::vector<std::string> assumed = assumptions(soil_, what_.soil);
      figure.remarks.insert(figure.remarks.end(), assumed.begin(), assumed.end());
    }
    if (what_.counts)
      figure.panels.push_back(counts_panel());
    if (!what_.particles.empty() || !what_.sizes.empty()) {
      Integer n = 0;
      for (const DrawnClass &c : what_.particles)
        n += c.quantity;
      figure.notes.push_back("N = " + count_text(Integer(n + what_.outside)));
      if (what_.outside > 0)
        figure.notes.push_back(std::string(texts_.outside) + count_text(what_.outside));
    }
    return figure;
  }

  /// Place on the x axis of a size in mm.
  double at_mm(const Rational &size) const { return log10_of(Rational(size / unit_mm_)); }

  /// The axis holds all that is drawn, classes from end to end, with room beside it; more where the curve or
  /// a class goes on below it.
  void set_x() {
    double low = at_mm(sizes_.back());
    double high = low;
    const auto cover = [&](double at) {
      low = std::min(low, at);
      high = std::max(high, at);
    };
    for (const Rational &size : sizes_)
      if (size > 0)
        cover(at_mm(size));
    bool is_open = has_pan();
    for (const DrawnClass &c : what_.particles) {
      cover(log10_of(c.size));
      cover(log10_of(c.upper));
      if (c.lower > 0)
        cover(log10_of(c.lower));
      else
        is_open = true;
    }
    for (const DrawnSize &s : what_.sizes)
      cover(log10_of(s.size));
    if (what_.envelope && what_.curve)
      for (const Rational &size : what_.envelope->sizes)
        if (size > 0)
          cover(at_mm(Rational(size * in_mm(what_.envelope->unit))));
    const double span = high > low ? high - low : 1;
    std::string title = fmt::format("{} ({})", texts_.size, unit_);
    if (what_.form.bare && what_.curve && what_.bands != Bands::none) // else a note says whose bands
      title += "; " + bands_text();
    x_ = log_axis(title, low - (is_open ? 0.2 : 0.06) * span, high + 0.06 * span);
    x_.reversed = what_.coarse_left;
  }

  /// True if the curve is not known below its finest sieve.
  bool has_pan() const { return curve_.has_pan() && curve_.shares()[1] > 0; }

  /// Distance in pt from the frame's side of the fine sizes.
  double from_finer_side(double at) const { return (at - x_.low) / x_.span() * width_; }

  Panel curve_panel() {
    Panel p;
    p.x = x_;
    p.y = {std::string(texts_.passing), 0, 100, {}};
    constexpr double narrow = 480;
    const bool has_right = what_.form.width == 0 || what_.form.width >= narrow;
    for (int i = 0; i <= 100; i += 10) {
      p.y.ticks.push_back({static_cast<double>(i), std::to_string(i)});
      if (has_right)
        p.right.push_back({static_cast<double>(i), std::to_string(100 - i)});
    }
    p.right_title = texts_.retained;
    p.grid = true;
    add_sieves(p);
    add_bands(p);
    add_envelope(p);
    add_curve(p);
    add_steps(p);
    for (const int percent : {10, 30, 60})
      add_diameter(p, percent);
    return p;
  }

  void add_sieves(Panel &p) const {
    if (what_.sieve_names == SieveNames::none)
      return;
    for (const Rational &size : sizes_) {
      if (size == 0)
        continue;
      const std::optional<std::string> name =
          what_.sieve_names == SieveNames::astm ? astm_sieve_name(size) : std::nullopt;
      p.top.push_back({at_mm(size), name.value_or(length_text(Rational(size / unit_mm_)))});
    }
  }

  std::vector<Fraction> fractions() const {
    switch (what_.bands) {
    case Bands::uscs:
      return soil_.uscs;
    case Bands::iso_14688:
      return soil_.iso_14688;
    case Bands::none:
      break;
    }
    return {};
  }

  /// Shades every other main band; their names stand below the axis, the names of their parts below these.
  void add_bands(Panel &p) const {
    Strip main;
    Strip parts;
    for (const Fraction &f : fractions()) {
      const double low = f.above > 0 ? at_mm(f.above) : x_.low;
      const double high = f.up_to ? at_mm(*f.up_to) : x_.high;
      if (high <= x_.low || low >= x_.high)
        continue;
      const Strip::Part part{std::max(low, x_.low), std::min(high, x_.high),
                             band_names(f.name, what_.form.language)};
      if (f.main) {
        if (main.parts.size() % 2 == 0)
          p.back.push_back({part.low, part.high, 0, 100, band_color});
        main.parts.push_back({part.low, part.high, {part.names.front()}});
      } else {
        parts.parts.push_back(part);
      }
      if (low > x_.low)
        p.series.push_back(line({{low, 0}, {low, 100}}, "#999999", Stroke::dotted));
    }
    if (!main.parts.empty())
      p.strips.push_back(main);
    if (!parts.parts.empty())
      p.strips.push_back(parts);
  }

  static Series line(std::vector<Point> points, const char *color, Stroke stroke) {
    Series s;
    s.points = std::move(points);
    s.color = color;
    s.stroke = stroke;
    s.width = 0.75;
    return s;
  }

  void add_envelope(Panel &p) const {
    if (!what_.envelope)
      return;
    for (const Series &series :
         limits_series(*what_.envelope, unit_mm_, std::string(texts_.allowed) + what_.envelope->id))
      p.series.push_back(series);
  }

  void add_curve(Panel &p) const {
    Series s;
    const bool has_set = !what_.particles.empty() || !what_.sizes.empty();
    s.title = std::string(has_set ? texts_.target : "");
    s.title += what_.of_particles ? texts_.particles : texts_.analysis;
    s.color = curve_color;
    constexpr std::size_t most_marks = 60;
    if (sizes_.size() <= most_marks) {
      s.mark = Mark::disc;
      s.mark_size = 0.6;
    }
    s.width = 2;
    for (std::size_t i = 0; i < sizes_.size(); ++i)
      if (sizes_[i] > 0)
        s.points.push_back({at_mm(sizes_[i]), percent(curve_.shares()[i])});
    if (has_pan()) {
      Series below = line({{x_.low, s.points[0].y}, s.points[0]}, curve_color, Stroke::dashed);
      below.width = s.width;
      p.series.push_back(below);
    }
    p.series.push_back(s);
  }

  /// The sizes of the particles: those of the classes where no others are given.
  std::vector<DrawnSize> steps() const {
    if (!what_.sizes.empty())
      return what_.sizes;
    std::vector<DrawnSize> steps;
    for (const DrawnClass &c : what_.particles)
      steps.push_back({c.size, c.mass});
    return steps;
  }

  /// The share of the set that passes a size: steps, each at a size of particles.
  void add_steps(Panel &p) const {
    const std::vector<DrawnSize> all = steps();
    if (all.empty())
      return;
    Rational total = 0;
    for (const DrawnSize &c : all)
      total += c.mass;
    Series s;
    s.title = texts_.particles;
    s.color = set_color;
    s.points.push_back({x_.low, 0});
    Rational below = 0;
    for (const DrawnSize &c : all) {
      const double at = log10_of(c.size);
      s.points.push_back({at, percent(Rational(below / total))});
      below += c.mass;
      s.points.push_back({at, percent(Rational(below / total))});
    }
    s.points.push_back({x_.high, 100});
    p.series.push_back(s);
  }

  Available<PowerProduct> diameter(int percent) const {
    return percent == 10 ? soil_.d10 : percent == 30 ? soil_.d30 : soil_.d60;
  }

  /// D_p as a mark on the curve with a line to the axis. Its name stands above the curve, on the finer side,
  /// where there are neither the curve nor such lines; on the other, below, where the frame is too near.
  void add_diameter(Panel &p, int percent) const {
    const Available<PowerProduct> d = diameter(percent);
    if (!d)
      return;
    constexpr unsigned bits = 64;
    const double at = at_mm(d->real().ball(bits).lower());
    const double y = percent;
    if (at < x_.low || at > x_.high)
      return;
    p.series.push_back(line({{at, 0}, {at, y}}, mark_color, Stroke::dashed));
    Series mark = line({{at, y}}, mark_color, Stroke::none);
    mark.mark = Mark::ring;
    mark.mark_size = 1;
    p.series.push_back(mark);
    const std::string text = fmt::format("D{}", percent);
    constexpr double away = 7;
    const double room = text_width(text, letter_size) + 2 * away;
    const bool finer = from_finer_side(at) > room;
    const bool leftwards = finer != x_.reversed;
    p.texts.push_back({at, y, text, leftwards ? Align::right : Align::left, leftwards ? -away : away,
                       finer ? away : -away});
  }

  void add_description(std::vector<std::string> &notes) const {
    constexpr unsigned digits = 3;
    for (const int percent : {10, 30, 60}) {
      const Available<PowerProduct> d = diameter(percent);
      if (d)
        notes.push_back(
            fmt::format("D{} = {} {}", percent, rounded(d->real() * Rational(1 / unit_mm_), digits), unit_));
      else if (has_pan())
        notes.push_back(fmt::format("D{} < {}", percent, finest()));
    }
    const auto add_index = [&](const char *what, const Available<PowerProduct> &index) {
      if (index)
        notes.push_back(fmt::format("{} = {}", what, rounded(index->real(), digits)));
    };
    add_index("Cu", soil_.c_u);
    add_index("Cc", soil_.c_c);
    if (has_pan())
      notes.push_back(fmt::format("{}{}: {} %", texts_.finer, finest(),
                                  rounded(Real(Rational(100 * curve_.shares()[1])), digits)));
    if (soil_.group) {
      notes.push_back("USCS " + soil_.group->symbol);
      notes.push_back(soil_.group->name);
    } else {
      notes.emplace_back(texts_.no_group);
    }
    if (what_.bands != Bands::none)
      notes.push_back(bands_text());
  }

  /// Whose bands these are.
  std::string bands_text() const {
    return std::string(texts_.bands) + (what_.bands == Bands::uscs ? "ASTM D2487" : "ISO 14688");
  }

  /// The finest sieve above the pan.
  std::string finest() const {
    return fmt::format("{} {}", length_text(Rational(sizes_[1] / unit_mm_)), unit_);
  }

  /// Bars over the classes, from half a particle on, with their numbers above them.
  Panel counts_panel() const {
    const double low = std::log10(0.5);
    double high = 1;
    double widest = 0;
    double narrowest = width_;
    for (const DrawnClass &c : what_.particles) {
      high = std::max(high, top(c));
      widest = std::max(widest, text_width(count_text(c.quantity), letter_size));
      narrowest = std::min(narrowest, right(c) - left(c));
    }
    const bool upright = widest + 4 > narrowest;
    const double room = ((upright ? widest : letter_size) + 12) / height_;
    Panel p;
    p.x = x_;
    p.y = log_axis(std::string(texts_.counts), low, (high - room * low) / (1 - room));
    p.y.ticks.erase(p.y.ticks.begin(), std::find_if(p.y.ticks.begin(), p.y.ticks.end(),
                                                    [](const Tick &t) { return t.at >= 0; }));
    p.grid = true;
    add_sieves(p);
    add_bands(p);
    p.series.clear(); // lines of bands would cross the numbers
    for (Rectangle &band : p.back) {
      band.y_low = p.y.low;
      band.y_high = p.y.high;
    }
    for (const DrawnClass &c : what_.particles)
      p.boxes.push_back(
          {c.lower > 0 ? log10_of(c.lower) : x_.low, log10_of(c.upper), low, top(c), "#8fb4d9", true});
    add_numbers(p, upright);
    return p;
  }

  /// The numbers of classes: all that have room, the largest first.
  void add_numbers(Panel &p, bool upright) const {
    constexpr double away = 4;
    constexpr double half_room = 0.55 * letter_size;
    constexpr double half_figure = 0.4 * letter_size;
    const std::vector<DrawnClass> &all = what_.particles;
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&all](std::size_t i, std::size_t j) { return all[i].quantity > all[j].quantity; });
    std::set<double> taken;
    for (const std::size_t j : order) {
      const DrawnClass &c = all[j];
      const double middle = (left(c) + right(c)) / 2;
      if (upright) {
        const auto next = taken.lower_bound(middle - 2 * half_room);
        if ((next != taken.end() && *next < middle + 2 * half_room) ||
            is_behind_a_bar(p, j, middle, half_figure, away))
          continue;
        taken.insert(middle);
      }
      const double at = (p.boxes[j].x_low + p.boxes[j].x_high) / 2;
      p.texts.push_back({at, top(c), count_text(c.quantity), upright ? Align::left : Align::center, 0,
                         upright ? away : letter_size * 0.7, upright});
    }
  }

  /// True if a neighbour's bar rises into the number of class j, which takes `half_room` on both sides.
  bool is_behind_a_bar(const Panel &p, std::size_t j, double middle, double half_room, double away) const {
    const std::vector<DrawnClass> &all = what_.particles;
    const double limit = top(all[j]) + away / height_ * p.y.span();
    const auto rises = [&](const DrawnClass &c) { return top(c) > limit; };
    const auto is_near = [&](const DrawnClass &c) {
      return right(c) > middle - half_room && left(c) < middle + half_room;
    };
    for (std::size_t i = j; i > 0 && is_near(all[i - 1]); --i)
      if (rises(all[i - 1]))
        return true;
    for (std::size_t i = j + 1; i < all.size() && is_near(all[i]); ++i)
      if (rises(all[i]))
        return true;
    return false;
  }

  static double top(const DrawnClass &c) { return log10_of(Rational(c.quantity)); }
  /// The ends of a class's bar in pt, as from the finer side; a pan at 0 begins at the frame.
  double left(const DrawnClass &c) const { return c.lower > 0 ? from_finer_side(log10_of(c.lower)) : 0; }
  double right(const DrawnClass &c) const { return from_finer_side(log10_of(c.upper)); }

  const Gradation &g_;
  const GradationFigure &what_;
  SoilDescription soil_;
  const GradingCurve &curve_;
  std::vector<Rational> sizes_; ///< of the curve, irrational ones rounded: a picture shows no more
  Rational unit_mm_;
  std::string_view unit_;
  const FigureTexts &texts_;
  Axis x_;
  double width_ = 0, height_ = 0;
};

} // namespace

Figure gradation_figure(const Gradation &g, const GradationFigure &what) {
  return Drawing(g, what).figure();
}

} // namespace mdm
