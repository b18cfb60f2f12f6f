#pragma once
/// \file
/// Figures: what is drawn and where, before any program draws it.

#include <mdm/number/rational.hpp>

#include <string>
#include <vector>

namespace mdm {

/// A mark of an axis; without a label it is a minor one.
struct Tick {
  double at;
  std::string label;
};

/// A stretch of the number line. A logarithmic axis is one of log10 of its values, with the values at its
/// ticks: all coordinates of a figure are in the axis's own measure, log10_of(value) where it is logarithmic.
struct Axis {
  std::string title;
  double low = 0;
  double high = 1;          ///< above `low`
  std::vector<Tick> ticks;  ///< ascending
  bool reversed = false;    ///< from `high` on the left or at the bottom
  bool on_the_tilt = false; ///< labels are written upwards

  double span() const { return high - low; }
};

/// A linear axis that covers [low, high] with ends and ticks at multiples of 1, 2 or 5 times a power of ten.
Axis linear_axis(const std::string &title, double low, double high);

/// A logarithmic axis of just [low, high] in log10, ticks at powers of ten and their multiples; at evenly
/// spaced values where there are no two powers.
Axis log_axis(const std::string &title, double low, double high);

/// log10(r) for r > 0 of any length, to some 15 digits: for drawing.
double log10_of(const Rational &r);

/// The style of a line.
enum class Stroke { none, solid, dashed, dotted };
/// The style of a point.
enum class Mark { none, disc, ring, square, triangle, diamond };

/// A place in a panel. A coordinate that is no number breaks a line.
struct Point {
  double x = 0;
  double y = 0;
  double value = 0;  ///< what the figure's colour scale shows
  double radius = 0; ///< of a disc, in the measure of x
};

/// Points, joined by a line, marked, or both.
struct Series {
  std::string title; ///< in the legend, once a title; empty: not there
  std::vector<Point> points;
  std::string color = "#1f4e79"; ///< red, green and blue in hexadecimal
  Stroke stroke = Stroke::solid;
  double width = 1.5; ///< of the line
  Mark mark = Mark::none;
  double mark_size = 0.5;
  bool by_value = false; ///< marks take their colour from Point::value
  bool filled = false;   ///< the inside of the closed line, and nothing else but its edge
  std::string edge;      ///< colour of the edge of what is filled; empty: none
  bool discs = false;    ///< discs at scale around the points: their circles, or filled
};

/// A filled rectangle; `framed` with a line around it.
struct Rectangle {
  double x_low = 0, x_high = 1;
  double y_low = 0, y_high = 1;
  std::string color = "#f0f0f0";
  bool framed = false;
};

/// The end of a text that stands at its place.
enum class Align { left, center, right };

/// Text at a place of a panel, moved from there by (dx, dy) pt; `dy` is up.
struct Text {
  double x = 0, y = 0;
  std::string text;
  Align align = Align::left;
  double dx = 0, dy = 0;
  bool upright = false; ///< written upwards, from its `align` end
};

/// A row of named stretches below the x axis.
struct Strip {
  /// One stretch, from `low` to `high` on the x axis.
  struct Part {
    double low, high;
    std::vector<std::string> names; ///< longest first; the first that fits is shown
  };
  std::vector<Part> parts;
};

/// One diagram.
struct Panel {
  std::string title;
  Axis x, y;
  std::vector<Tick> top;        ///< marks of the upper side, labels upright; those without room are left out
  std::string right_title;      ///< of the right side, if it has ticks
  std::vector<Tick> right;      ///< marks of the right side
  bool grid = false;            ///< lines at the ticks of y and the labelled ones of x
  bool framed = true;           ///< a line around it
  std::vector<Rectangle> back;  ///< behind everything
  std::vector<Rectangle> boxes; ///< in front of the grid
  std::vector<Series> series;
  std::vector<Text> texts;
  std::vector<Strip> strips;
};

/// Panels in rows of `columns`, all of one size.
struct Figure {
  std::string title;
  std::string description;  ///< in words, for those who do not see it
  double panel_width = 560; ///< pt, the frame of a panel without its labels
  double panel_height = 380;
  std::size_t columns = 1;
  std::vector<Panel> panels;
  std::vector<std::string> notes;   ///< lines below the panels, or beside a colour bar
  std::vector<std::string> remarks; ///< sentences below all else, as wide as the figure
  std::optional<Axis> colors;       ///< scale of Point::value, drawn as a bar
  bool bare = false;                ///< title, notes and remarks are not drawn: they stand elsewhere
};

/// Width in pt, rather too large than too small, of one line of text in letters of `size` pt.
double text_width(std::string_view text, double size);

/// Letters of ticks, titles and notes, in pt.
inline constexpr double letter_size = 11;

/// `text` as it is drawn: in one line, control and non-UTF-8 bytes escaped in hexadecimal, and so the
/// characters beyond Latin, Greek, Cyrillic and common signs: a font that lacks one draws a box.
std::string drawable(std::string_view text);

/// Titles and notes of the figure in which drawable() escapes a character that fonts may lack.
std::vector<std::string> escaped_texts(const Figure &figure);

/// `text` as drawable(), cut to `width` pt, with three dots at its end where it was cut.
std::string fitted(std::string_view text, double width, double size = letter_size);

/// `text` as drawable() in lines of at most `width` pt, broken at spaces; a word that is longer is cut as by
/// fitted().
std::vector<std::string> wrapped(std::string_view text, double width);

} // namespace mdm
