#include "plot/panel_painter.hpp"

#include "plot/figure_layout.hpp"
#include "plot/palette.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace mdm {
namespace {

constexpr double mark_radius = 4; // pt, of a mark of size 1
constexpr double largest_legend_mark = 1.4;
const Look frame_line{"", "#000000", 1, Stroke::solid};
const Look thin_box{"#ffffff", "#333333", 0.75, Stroke::solid};

void line(Canvas &canvas, Place from, Place to, const Look &look) {
  canvas.lines({{from, to}}, false, look);
}

/// A mark around a place.
void paint_mark(Canvas &canvas, Mark mark, Place at, double size, const std::string &color) {
  const double r = mark_radius * size;
  const auto polygon = [&](std::vector<Place> places) {
    canvas.lines({std::move(places)}, true, {color, "", 0, Stroke::solid});
  };
  switch (mark) {
  case Mark::none:
    return;
  case Mark::disc:
    return canvas.circle(at, r, {color, "", 0, Stroke::solid});
  case Mark::ring:
    return canvas.circle(at, r, {"", color, 1, Stroke::solid});
  case Mark::square:
    return polygon(corners({at.x - r, at.x + r, at.y - r, at.y + r}));
  case Mark::triangle:
    return polygon(
        {{at.x, at.y - 1.2 * r}, {at.x + 1.1 * r, at.y + 0.7 * r}, {at.x - 1.1 * r, at.y + 0.7 * r}});
  case Mark::diamond:
    return polygon(
        {{at.x, at.y - 1.3 * r}, {at.x + 1.3 * r, at.y}, {at.x, at.y + 1.3 * r}, {at.x - 1.3 * r, at.y}});
  }
}

class PanelPainter {
public:
  PanelPainter(Canvas &canvas, const Panel &panel, const Frame &frame, const Axis *colors)
      : canvas_(canvas), p_(panel), r_(frame), colors_(colors) {}

  void paint(double room) {
    canvas_.clip(r_);
    paint_boxes(p_.back);
    if (p_.grid)
      paint_grid();
    paint_boxes(p_.boxes);
    for (const Series &s : p_.series)
      paint_series(s);
    canvas_.unclip();
    if (p_.framed)
      canvas_.lines({corners(r_)}, true, frame_line);
    paint_ticks();
    paint_strips();
    paint_top_labels();
    paint_texts();
    paint_titles(room);
  }

private:
  /// So far out that it is the same as anything farther, near enough for canvases to count.
  static double near(double pt) {
    constexpr double far = 1e6;
    return std::clamp(pt, -far, far);
  }
  static double part(const Axis &axis, double at) {
    const double share = (at - axis.low) / axis.span();
    return axis.reversed ? 1 - share : share;
  }
  double across(double x) const { return near(r_.left + part(p_.x, x) * (r_.right - r_.left)); }
  double up(double y) const { return near(r_.bottom - part(p_.y, y) * (r_.bottom - r_.top)); }
  Place place(double x, double y) const { return {across(x), up(y)}; }
  bool is_inside(double x, double y) const {
    const auto in = [](const Axis &a, double at) { return a.low <= at && at <= a.high; };
    return in(p_.x, x) && in(p_.y, y);
  }
  static bool is_on(const Axis &axis, const Tick &t) {
    constexpr double slack = 1e-9;
    return axis.low - slack * axis.span() <= t.at && t.at <= axis.high + slack * axis.span();
  }

  void paint_boxes(const std::vector<Rectangle> &boxes) {
    for (const Rectangle &b : boxes) {
      const Place a = place(b.x_low, b.y_low), c = place(b.x_high, b.y_high);
      const Frame f{std::min(a.x, c.x), std::max(a.x, c.x), std::min(a.y, c.y), std::max(a.y, c.y)};
      Look look{b.color, "", 0, Stroke::solid};
      if (b.framed)
        look = {b.color, thin_box.line, thin_box.width, Stroke::solid};
      canvas_.lines({corners(f)}, true, look);
    }
  }

  void paint_grid() {
    const Look look{"", "#dddddd", 0.5, Stroke::solid};
    for (const Tick &t : p_.x.ticks)
      if (!t.label.empty() && is_on(p_.x, t))
        line(canvas_, {across(t.at), r_.top}, {across(t.at), r_.bottom}, look);
    for (const Tick &t : p_.y.ticks)
      if (!t.label.empty() && is_on(p_.y, t))
        line(canvas_, {r_.left, up(t.at)}, {r_.right, up(t.at)}, look);
  }

  /// Leaves out places of a long line that are too near to the one before them to be seen.
  static void leave_out_unseen(std::vector<Place> &piece) {
    constexpr std::size_t long_line = 2000;
    constexpr double seen = 0.25; // pt
    if (piece.size() <= long_line)
      return;
    std::vector<Place> kept;
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (i == 0 || i + 1 == piece.size() ||
          std::hypot(piece[i].x - kept.back().x, piece[i].y - kept.back().y) >= seen)
        kept.push_back(piece[i]);
    piece = std::move(kept);
  }

  /// The pieces of a line between its gaps.
  std::vector<std::vector<Place>> pieces(const Series &s) const {
    std::vector<std::vector<Place>> all(1);
    for (const Point &p : s.points)
      if (std::isfinite(p.x) && std::isfinite(p.y))
        all.back().push_back(place(p.x, p.y));
      else if (!all.back().empty())
        all.emplace_back();
    if (all.back().empty())
      all.pop_back();
    for (std::vector<Place> &piece : all)
      leave_out_unseen(piece);
    return all;
  }

  void paint_series(const Series &s) {
    if (s.discs)
      return paint_discs(s);
    if (s.filled)
      return canvas_.lines(pieces(s), true, {s.color, s.edge, s.width, Stroke::solid});
    if (s.stroke != Stroke::none && s.points.size() > 1)
      canvas_.lines(pieces(s), false, {"", s.color, s.width, s.stroke});
    for (const Point &p : s.points)
      if (s.mark != Mark::none && is_inside(p.x, p.y))
        paint_mark(canvas_, s.mark, place(p.x, p.y), s.mark_size,
                   s.by_value && colors_ != nullptr ? palette_color(part(*colors_, p.value)) : s.color);
  }

  void paint_discs(const Series &s) {
    const double pt_per_x = (r_.right - r_.left) / p_.x.span();
    const Look look =
        s.filled ? Look{s.color, s.edge, s.width, Stroke::solid} : Look{"", s.color, s.width, s.stroke};
    for (const Point &p : s.points)
      canvas_.circle(place(p.x, p.y), p.radius * pt_per_x, look);
  }

  /// The ticks of x without the labels that would overlap one before them.
  std::vector<Tick> with_room() const {
    std::vector<Tick> ticks = p_.x.ticks;
    if (p_.x.reversed)
      std::reverse(ticks.begin(), ticks.end());
    std::optional<double> taken;
    for (Tick &t : ticks) {
      if (t.label.empty())
        continue;
      const double half = (p_.x.on_the_tilt ? letter_size : text_width(t.label, letter_size)) / 2;
      if (taken && across(t.at) - half < *taken)
        t.label.clear();
      else
        taken = across(t.at) + half + 2;
    }
    return ticks;
  }

  static double length(const Tick &t) { return t.label.empty() ? tick_length / 2 : tick_length; }

  void paint_ticks() {
    for (const Tick &t : with_room()) {
      if (!is_on(p_.x, t))
        continue;
      const double x = across(t.at);
      line(canvas_, {x, r_.bottom}, {x, r_.bottom + length(t)}, frame_line);
      const double below = r_.bottom + tick_length + text_gap / 2;
      if (p_.x.on_the_tilt)
        text({x, below}, t.label, {Align::right, letter_size, true});
      else
        text({x, below + line_height / 2}, t.label, {Align::center, letter_size, false});
    }
    for (const Tick &t : p_.y.ticks)
      if (is_on(p_.y, t)) {
        line(canvas_, {r_.left, up(t.at)}, {r_.left - length(t), up(t.at)}, frame_line);
        text({r_.left - tick_length - text_gap / 2, up(t.at)}, t.label, {Align::right, letter_size, false});
      }
    for (const Tick &t : p_.right)
      if (is_on(p_.y, t)) {
        line(canvas_, {r_.right, up(t.at)}, {r_.right + length(t), up(t.at)}, frame_line);
        text({r_.right + tick_length + text_gap / 2, up(t.at)}, t.label, {Align::left, letter_size, false});
      }
    constexpr double apart = 0.5; // pt: nearer marks are one to the eye
    std::optional<double> last;
    for (const Tick &t : p_.top)
      if (is_on(p_.x, t) && (!last || std::abs(across(t.at) - *last) >= apart)) {
        last = across(t.at);
        line(canvas_, {*last, r_.top}, {*last, r_.top - tick_length}, frame_line);
      }
  }

  /// The labels of the upper side for which there is room: the outermost, and the others from the left.
  void paint_top_labels() {
    std::vector<std::pair<double, const Tick *>> kept;
    std::vector<std::pair<double, const Tick *>> all;
    for (const Tick &t : p_.top)
      if (!t.label.empty() && is_on(p_.x, t))
        all.emplace_back(across(t.at), &t);
    std::sort(all.begin(), all.end());
    const double room = 1.1 * letter_size;
    for (const auto &next : all)
      if (kept.empty() || next.first - kept.back().first >= room)
        kept.push_back(next);
    if (!all.empty() && kept.size() > 1 && kept.back() != all.back())
      kept.back() = all.back();
    for (const auto &[x, tick] : kept)
      text({x, r_.top - tick_length - text_gap}, tick->label, {Align::left, letter_size, true});
  }

  void paint_strips() {
    double top = r_.bottom + below_ticks(p_);
    for (const Strip &strip : p_.strips) {
      for (const Strip::Part &part : strip.parts) {
        const double a = across(std::clamp(part.low, p_.x.low, p_.x.high));
        const double b = across(std::clamp(part.high, p_.x.low, p_.x.high));
        const Frame f{std::min(a, b), std::max(a, b), top, top + line_height};
        if (f.right - f.left >= 1)
          paint_part(part, f);
      }
      top += line_height;
    }
  }

  void paint_part(const Strip::Part &part, const Frame &f) {
    canvas_.lines({corners(f)}, true, thin_box);
    for (const std::string &name : part.names)
      if (text_width(name, letter_size) + 4 <= f.right - f.left)
        return text({(f.left + f.right) / 2, (f.top + f.bottom) / 2}, name,
                    {Align::center, letter_size, false});
  }

  void paint_texts() {
    for (const Text &t : p_.texts) {
      const Place at = place(t.x, t.y);
      text({at.x + t.dx, at.y - t.dy}, t.text, {t.align, letter_size, t.upright});
    }
  }

  void paint_titles(double room) {
    const Margins m = margins(p_);
    const double middle = (r_.left + r_.right) / 2, half_way = (r_.bottom + r_.top) / 2;
    const double half_line = line_height / 2;
    const TextLook flat{Align::center, letter_size, false}, upright{Align::center, letter_size, true};
    text({middle, r_.top - m.top + half_line}, fitted(p_.title, room), flat);
    text({middle, r_.bottom + m.bottom - text_gap - half_line}, p_.x.title, flat);
    text({r_.left - m.left + text_gap + half_line, half_way}, p_.y.title, upright);
    if (!p_.right.empty())
      text({r_.right + m.right - text_gap - half_line, half_way}, p_.right_title, upright);
  }

  void text(Place at, const std::string &text, const TextLook &look) {
    if (!text.empty())
      canvas_.text(at, drawable(text), look);
  }

  Canvas &canvas_;
  const Panel &p_;
  Frame r_;
  const Axis *colors_;
};

} // namespace

void paint_panel(Canvas &canvas, const Panel &panel, const Frame &frame, double room, const Axis *colors) {
  PanelPainter(canvas, panel, frame, colors).paint(room);
}

void paint_legend_sample(Canvas &canvas, const Series &series, double left, double right, double y) {
  const Place middle{(left + right) / 2, y};
  if (series.discs)
    return paint_mark(canvas, series.filled ? Mark::disc : Mark::ring, middle, largest_legend_mark,
                      series.color);
  if (series.filled) {
    const double half = line_height / 3;
    return canvas.lines({corners({left, right, y - half, y + half})}, true,
                        {series.color, series.edge, series.width, Stroke::solid});
  }
  if (series.stroke != Stroke::none)
    line(canvas, {left, y}, {right, y}, {"", series.color, series.width, series.stroke});
  paint_mark(canvas, series.mark, middle, std::min(series.mark_size, largest_legend_mark), series.color);
}

} // namespace mdm
