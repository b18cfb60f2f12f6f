#include "plot/gnuplot_script.hpp"

#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

namespace mdm {
namespace {

constexpr double title_size = 13;
constexpr double legend_mark = 1.4; // largest that fits a line of the legend
constexpr double line_height = 1.35 * letter_size;
constexpr double text_gap = 6;
constexpr double tick_length = 5;
constexpr double color_bar_width = 14;
constexpr double legend_sample = 34;
constexpr double widest_note = 300;

const char *terminal(Picture picture) {
  // Each makes letters, lines and marks of the same share of the picture.
  static constexpr std::array<const char *, 3> names = {
      "svg size {w:.0f},{h:.0f} noenhanced font 'sans-serif,{f}' background '#ffffff'",
      "pngcairo size {w2:.0f},{h2:.0f} noenhanced font 'Sans,{f}' fontscale 1.5 linewidth 2 pointscale 2",
      "pdfcairo size {wi:.4f}in,{hi:.4f}in noenhanced font 'Sans,{f}'"};
  return names.at(static_cast<std::size_t>(picture));
}

/// Text as wide as the widest label.
double widest(const std::vector<Tick> &ticks) {
  double width = 0;
  for (const Tick &t : ticks)
    width = std::max(width, text_width(t.label, letter_size));
  return width;
}

/// The room around a panel's frame, in pt.
struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0;

  void cover(const Margins &other) {
    left = std::max(left, other.left);
    right = std::max(right, other.right);
    top = std::max(top, other.top);
    bottom = std::max(bottom, other.bottom);
  }
};

double below_ticks(const Panel &p) {
  return tick_length + text_gap + (p.x.on_the_tilt ? widest(p.x.ticks) : line_height);
}

Margins margins(const Panel &p) {
  const double title = line_height + text_gap;
  Margins m;
  m.left = title + widest(p.y.ticks) + tick_length + 2 * text_gap;
  m.right = p.right.empty() ? 3 * text_gap : title + widest(p.right) + tick_length + 2 * text_gap;
  m.top =
      text_gap + (p.title.empty() ? 0 : title) + (p.top.empty() ? 0 : widest(p.top) + tick_length + text_gap);
  m.bottom = below_ticks(p) + static_cast<double>(p.strips.size()) * line_height + title + text_gap;
  return m;
}

/// A frame in pt from the lower left corner of the picture.
struct Frame {
  double left, right, bottom, top;
};

class Script {
public:
  Script(const Figure &figure, Picture picture) : f_(figure) {
    arrange();
    const double pt_per_inch = 72;
    add("# Draw with: gnuplot -d THIS_FILE > PICTURE\n");
    add("set encoding utf8\nset terminal ");
    fmt::format_to(std::back_inserter(text_), fmt::runtime(terminal(picture)), fmt::arg("w", width_),
                   fmt::arg("h", height_), fmt::arg("w2", 2 * width_), fmt::arg("h2", 2 * height_),
                   fmt::arg("wi", width_ / pt_per_inch), fmt::arg("hi", height_ / pt_per_inch),
                   fmt::arg("f", letter_size));
    add("\n");
    for (std::size_t i = 0; i < f_.panels.size(); ++i)
      for (std::size_t j = 0; j < f_.panels[i].series.size(); ++j)
        add_data(block(i, j), f_.panels[i], f_.panels[i].series[j]);
    add("set multiplot\nset border 31 linewidth 1\nset tics front\n");
    add("set palette defined (0 '#440154', 1 '#472c7a', 2 '#3b518b', 3 '#2c718e', 4 '#21908d', 5 '#27ad81', "
        "6 '#5cc863', 7 '#aadc32', 8 '#fde725')\n");
    for (std::size_t i = 0; i < f_.panels.size(); ++i)
      add_panel(i);
    add("unset multiplot\n");
  }

  std::string take() { return fmt::to_string(text_); }

private:
  template <class... Args>
  void add(fmt::format_string<Args...> format, Args &&...args) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Args>(args)...);
  }

  static std::string block(std::size_t panel, std::size_t series) {
    return fmt::format("$panel{}_series{}", panel + 1, series + 1);
  }

  /// Places everything: the panels' grid, then beside it the colour bar, or below it the legend and the
  /// notes.
  void arrange() {
    for (const Panel &p : f_.panels) {
      margins_.cover(margins(p));
      for (const Series &s : p.series)
        if (!s.title.empty() && titles_.insert(s.title).second)
          legend_.push_back(&s);
    }
    const double panels = static_cast<double>(f_.panels.size());
    const double columns = std::min(panels, static_cast<double>(f_.columns));
    cell_width_ = margins_.left + f_.panel_width + margins_.right;
    cell_height_ = margins_.top + f_.panel_height + margins_.bottom;
    const double grid_width = columns * cell_width_, grid_height = std::ceil(panels / columns) * cell_height_;
    const double title = f_.title.empty() ? 0 : 2 * title_size;
    if (f_.colors)
      arrange_beside(grid_width, grid_height);
    else
      arrange_below(grid_width, grid_height);
    height_ += title;
    top_ = height_ - title;
  }

  double legend_width() const {
    double width = 0;
    for (const Series *s : legend_)
      width = std::max(width, legend_sample + 2 * text_gap + text_width(legend_title(*s), letter_size));
    return width;
  }

  double notes_width() const {
    double width = 0;
    for (const std::string &note : f_.notes)
      width = std::max(width, text_width(fitted(note, widest_note), letter_size));
    return width;
  }

  /// A colour bar, and beside it the legend above the notes.
  void arrange_beside(double grid_width, double grid_height) {
    colors_left_ = grid_width;
    side_left_ =
        colors_left_ + color_bar_width + tick_length + widest(f_.colors->ticks) + line_height + 3 * text_gap;
    const double side = std::max(legend_width(), notes_width());
    width_ = std::ceil(side_left_ + (side > 0 ? side + 3 * text_gap : 0));
    height_ = std::ceil(std::max(
        grid_height, 2 * text_gap + line_height * static_cast<double>(legend_.size() + f_.notes.size() + 1)));
    note_rows_ = f_.notes.size();
  }

  /// The legend below the panels, and at its right the notes in columns.
  void arrange_below(double grid_width, double grid_height) {
    side_left_ = margins_.left;
    note_width_ = notes_width() + 3 * text_gap;
    notes_left_ = side_left_ + (legend_.empty() ? 0 : legend_width() + 3 * text_gap);
    const double notes_end = f_.notes.empty() ? 0 : note_width_;
    width_ = std::ceil(std::max(grid_width, notes_left_ + notes_end));
    const auto note_columns =
        static_cast<std::size_t>(std::max(1.0, std::floor((width_ - notes_left_) / note_width_)));
    note_rows_ = std::max(legend_.size(), (f_.notes.size() + note_columns - 1) / note_columns);
    below_ = note_rows_ == 0 ? 0 : text_gap + line_height * static_cast<double>(note_rows_);
    height_ = std::ceil(grid_height + below_);
  }

  static std::string legend_title(const Series &s) {
    return fitted(s.title, widest_note - legend_sample - 2 * text_gap);
  }

  Frame frame(std::size_t panel) const {
    const double row = static_cast<double>(panel / f_.columns);
    const double column = static_cast<double>(panel % f_.columns);
    const double left = column * cell_width_ + margins_.left;
    const double top = top_ - row * cell_height_ - margins_.top;
    return {left, left + f_.panel_width, top - f_.panel_height, top};
  }

  /// Place of x in pt.
  static double across(const Frame &r, const Axis &axis, double x) {
    const double part = (x - axis.low) / axis.span();
    return r.left + (axis.reversed ? 1 - part : part) * (r.right - r.left);
  }

  std::string screen(double x, double y) const {
    return fmt::format("screen {:.6f},screen {:.6f}", x / width_, y / height_);
  }

  void add_data(const std::string &name, const Panel &panel, const Series &s) {
    add("{} << EOD\n", name);
    for (const Point &p : s.points) {
      if (s.discs)
        add_disc(p, f_.panel_width / panel.x.span());
      else if (!std::isfinite(p.x) || !std::isfinite(p.y))
        add("\n");
      else if (s.by_value)
        add("{:.12g} {:.12g} {:.12g}\n", p.x, p.y, p.value);
      else
        add("{:.12g} {:.12g}\n", p.x, p.y);
    }
    add("EOD\n");
  }

  /// A polygon of a disc's corners, that is nowhere farther from it than can be seen. gnuplot's own circles
  /// have so many corners that a packing would fill a hundred megabytes.
  void add_disc(const Point &p, double pt_per_x) {
    constexpr double seen = 0.05; // pt
    constexpr double pi = 3.141592653589793;
    const double r = std::max(p.radius * pt_per_x, 2 * seen);
    const double corners = std::max(8.0, std::ceil(pi / std::acos(1 - seen / r)));
    for (double i = 0; i <= corners; ++i) {
      const double angle = 2 * pi * (i < corners ? i : 0) / corners;
      add("{:.7g} {:.7g}\n", p.x + p.radius * std::cos(angle), p.y + p.radius * std::sin(angle));
    }
    add("\n");
  }

  void add_label(double x, double y, std::string_view text, Align align, const char *more = "") {
    add_label_at(screen(x, y), text, align, more);
  }

  void add_label_at(const std::string &place, std::string_view text, Align align, const std::string &more) {
    static constexpr std::array<const char *, 3> names = {"left", "center", "right"};
    if (!text.empty())
      add("set label {} at {} {} front{}\n", gnuplot_string(text), place,
          names.at(static_cast<std::size_t>(align)), more);
  }

  void add_range(const char *axis, const Axis &a) {
    add("set {}range [{:.12g}:{:.12g}]\n", axis, a.reversed ? a.high : a.low, a.reversed ? a.low : a.high);
  }

  void add_ticks(const char *axis, const std::vector<Tick> &ticks, const char *more) {
    add("set {}tics {}(", axis, more);
    const char *comma = "";
    for (const Tick &t : ticks) {
      add("{}{} {:.12g}{}", comma, tick_label(t.label), t.at, t.label.empty() ? " 1" : "");
      comma = ", ";
    }
    add(")\n");
  }

  /// The ticks of an axis below a frame, without the labels that would overlap one before them.
  static std::vector<Tick> with_room(const Axis &axis, const Frame &r) {
    std::vector<Tick> ticks = axis.ticks;
    double taken = -2 * r.right; // below all places, of either sign
    const double sign = axis.reversed ? -1 : 1;
    for (Tick &t : ticks) {
      if (t.label.empty())
        continue;
      const double half = (axis.on_the_tilt ? letter_size : text_width(t.label, letter_size)) / 2;
      const double at = sign * across(r, axis, t.at);
      if (at - half < taken)
        t.label.clear();
      else
        taken = at + half + 2;
    }
    return ticks;
  }

  /// Labels of ticks are formats of a number.
  static std::string tick_label(const std::string &label) {
    std::string format;
    for (const char c : label)
      format += c == '%' ? "%%" : std::string(1, c);
    return gnuplot_string(format);
  }

  void add_axes(const Panel &p, const Frame &r) {
    add_range("x", p.x);
    add_ticks("x", with_room(p.x, r), p.x.on_the_tilt ? "out nomirror rotate by 90 right " : "out nomirror ");
    add_range("y", p.y);
    add_ticks("y", p.y.ticks, "out nomirror ");
    if (p.top.empty()) {
      add("unset x2tics\n");
    } else {
      std::vector<Tick> marks = p.top;
      for (Tick &t : marks)
        t.label.clear();
      add_range("x2", p.x);
      add_ticks("x2", marks, "out scale 1,1 ");
    }
    if (p.right.empty()) {
      add("unset y2tics\n");
    } else {
      add_range("y2", p.y);
      add_ticks("y2", p.right, "out nomirror ");
    }
    add("{}",
        p.grid ? "set grid xtics ytics back linetype 1 linecolor '#dddddd' linewidth 0.5\n" : "unset grid\n");
  }

  void add_boxes(const std::vector<Rectangle> &boxes, const char *layer) {
    for (const Rectangle &b : boxes)
      add("set object rectangle from first {:.12g},{:.12g} to first {:.12g},{:.12g} {} clip fillcolor rgb {} "
          "fillstyle solid {}\n",
          b.x_low, b.y_low, b.x_high, b.y_high, layer, gnuplot_string(b.color),
          b.framed ? "border linecolor '#333333' linewidth 0.75" : "noborder");
  }

  void add_strips(const Panel &p, const Frame &r) {
    double top = r.bottom - below_ticks(p);
    for (const Strip &strip : p.strips) {
      const double bottom = top - line_height;
      for (const Strip::Part &part : strip.parts) {
        const double a = across(r, p.x, std::clamp(part.low, p.x.low, p.x.high));
        const double b = across(r, p.x, std::clamp(part.high, p.x.low, p.x.high));
        const double left = std::min(a, b);
        const double right = std::max(a, b);
        if (right - left < 1)
          continue;
        add("set object rectangle from {} to {} front fillcolor rgb '#ffffff' fillstyle solid border "
            "linecolor "
            "'#333333' linewidth 0.75\n",
            screen(left, bottom), screen(right, top));
        for (const std::string &text : part.names)
          if (text_width(text, letter_size) + 4 <= right - left) {
            add_label((left + right) / 2, (top + bottom) / 2, text, Align::center);
            break;
          }
      }
      top = bottom;
    }
  }

  /// The labels of the upper side for which there is room: the outermost, and the others from the left.
  void add_top(const Panel &p, const Frame &r) {
    std::vector<std::pair<double, const Tick *>> kept;
    std::vector<std::pair<double, const Tick *>> all;
    for (const Tick &t : p.top)
      if (!t.label.empty() && t.at >= p.x.low && t.at <= p.x.high)
        all.emplace_back(across(r, p.x, t.at), &t);
    std::sort(all.begin(), all.end());
    const double room = 1.1 * letter_size;
    for (const auto &next : all)
      if (kept.empty() || next.first - kept.back().first >= room)
        kept.push_back(next);
    if (!all.empty() && kept.size() > 1 && kept.back() != all.back())
      kept.back() = all.back();
    for (const auto &[x, tick] : kept)
      add_label(x, r.top + tick_length + text_gap, tick->label, Align::left, " rotate by 90");
  }

  void add_texts(const Panel &p, const Frame &r) {
    for (const Text &t : p.texts)
      add_label_at(fmt::format("first {:.12g},{:.12g}", t.x, t.y), t.text, t.align,
                   fmt::format(" offset screen {:.6f},{:.6f}{}", t.dx / width_, t.dy / height_,
                               t.upright ? " rotate by 90" : ""));
    const double middle = (r.left + r.right) / 2;
    const double half_way = (r.bottom + r.top) / 2;
    const double half_line = line_height / 2;
    const Margins m = margins(p);
    add_label(middle, r.top + m.top - half_line, fitted(p.title, cell_width_), Align::center);
    add_label(middle, r.bottom - m.bottom + text_gap + half_line, p.x.title, Align::center);
    add_label(r.left - m.left + text_gap + half_line, half_way, p.y.title, Align::center, " rotate by 90");
    if (!p.right.empty())
      add_label(r.right + m.right - text_gap - half_line, half_way, p.right_title, Align::center,
                " rotate by 90");
  }

  /// Things drawn once a figure, with its first panel.
  void add_surroundings() {
    if (!f_.title.empty())
      add_label_at(screen(margins_.left, height_ - title_size),
                   fitted(f_.title, width_ - margins_.left - text_gap, title_size), Align::left,
                   fmt::format(" font ',{}'", title_size));
    const double top = f_.colors ? top_ - text_gap : below_;
    if (legend_.empty())
      add("unset key\n");
    else
      add("set key at {} top left Left reverse samplen 3 spacing 1.1 noautotitle\n", screen(side_left_, top));
    add_notes(top - line_height / 2);
    if (!f_.colors)
      return;
    const Frame r = frame(0);
    const double last = frame(f_.panels.size() - 1).bottom;
    add("set colorbox vertical user origin {} size screen {:.6f},{:.6f}\n", screen(colors_left_, last),
        color_bar_width / width_, (r.top - last) / height_);
    add_range("cb", *f_.colors);
    add_ticks("cb", f_.colors->ticks, "");
    add_label(side_left_ - 2 * text_gap - line_height / 2, (r.top + last) / 2, f_.colors->title,
              Align::center, " rotate by 90");
  }

  /// \param y  of the first line
  void add_notes(double y) {
    double left = f_.colors ? side_left_ : notes_left_;
    if (f_.colors && !legend_.empty())
      y -= line_height * static_cast<double>(legend_.size() + 1);
    for (std::size_t i = 0; i < f_.notes.size(); ++i) {
      if (i > 0 && i % note_rows_ == 0)
        left += note_width_;
      add_label(left, y - line_height * static_cast<double>(i % note_rows_), fitted(f_.notes[i], widest_note),
                Align::left);
    }
  }

  void add_panel(std::size_t i) {
    const Panel &p = f_.panels[i];
    const Frame r = frame(i);
    add("unset label\nunset object\n");
    add("set lmargin at screen {:.6f}\nset rmargin at screen {:.6f}\n", r.left / width_, r.right / width_);
    add("set bmargin at screen {:.6f}\nset tmargin at screen {:.6f}\n", r.bottom / height_, r.top / height_);
    add_axes(p, r);
    add_boxes(p.back, "behind");
    add_boxes(p.boxes, "back");
    add_strips(p, r);
    add_top(p, r);
    add_texts(p, r);
    if (i == 0)
      add_surroundings();
    else
      add("unset key\nunset colorbox\n");
    // The colour bar is drawn with a plot that takes colours from it.
    const auto by_value = [](const Series &series) { return series.by_value; };
    add("{}", i == 0 && f_.colors && std::none_of(p.series.begin(), p.series.end(), by_value)
                  ? "plot NaN with points linecolor palette notitle"
                  : "plot NaN notitle");
    for (std::size_t j = 0; j < p.series.size(); ++j)
      if (!p.series[j].points.empty())
        add(", \\\n  {} using 1:2{} with {} notitle", block(i, j), p.series[j].by_value ? ":3" : "",
            look(p.series[j], p.series[j].by_value, p.series[j].mark_size));
    for (std::size_t j = 0; i == 0 && j < legend_.size(); ++j)
      add(", \\\n  keyentry with {} title {}", legend_look(*legend_[j]),
          gnuplot_string(legend_title(*legend_[j])));
    add("\n");
  }

  static std::string legend_look(const Series &s) {
    if (!s.discs)
      return look(s, false, std::min(s.mark_size, legend_mark));
    Series mark;
    mark.color = s.color;
    mark.stroke = Stroke::none;
    mark.mark = s.filled ? Mark::disc : Mark::ring;
    return look(mark, false, legend_mark);
  }

  static std::string look(const Series &s, bool by_value, double mark_size) {
    static constexpr std::array<const char *, 4> dashes = {"1", "1", "(9,5)", "(2,3)"};
    static constexpr std::array<int, 6> marks = {0, 7, 6, 5, 9, 13};
    const std::string color = by_value ? "linecolor palette" : "linecolor rgb " + gnuplot_string(s.color);
    if (s.filled)
      return fmt::format("filledcurves closed fillcolor rgb {} linewidth {} fillstyle solid {}",
                         gnuplot_string(s.color), s.width,
                         s.edge.empty() ? "noborder" : "border linecolor rgb " + gnuplot_string(s.edge));
    const std::string line =
        fmt::format("linewidth {} dashtype {}", s.width, dashes.at(static_cast<std::size_t>(s.stroke)));
    const std::string mark =
        fmt::format("pointtype {} pointsize {}", marks.at(static_cast<std::size_t>(s.mark)), mark_size);
    if (s.mark == Mark::none)
      return fmt::format("lines {} {}", color, line);
    if (s.stroke == Stroke::none)
      return fmt::format("points {} {}", color, mark);
    return fmt::format("linespoints {} {} {}", color, line, mark);
  }

  const Figure &f_;
  fmt::memory_buffer text_;
  Margins margins_;
  std::vector<const Series *> legend_;
  std::set<std::string> titles_;
  double cell_width_ = 0, cell_height_ = 0;
  double colors_left_ = 0, side_left_ = 0, notes_left_ = 0; ///< of the bar, the legend and the notes
  double note_width_ = 0;                                   ///< of a column of notes
  std::size_t note_rows_ = 0;
  double below_ = 0; ///< height of what stands below the panels
  double width_ = 0, height_ = 0;
  double top_ = 0; ///< of the panels
};

} // namespace

std::string gnuplot_string(std::string_view text) {
  constexpr std::string_view harmless = " .,:;()=/+-%#<>_";
  std::string quoted = "\"";
  for (const char c : drawable(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool alphanumeric = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (alphanumeric || byte >= 0x80 || harmless.find(c) != std::string_view::npos)
      quoted += c;
    else
      quoted += fmt::format("\\{:03o}", byte);
  }
  return quoted + "\"";
}

std::string gnuplot_script(const Figure &figure, Picture picture) {
  return Script(figure, picture).take();
}

} // namespace mdm
