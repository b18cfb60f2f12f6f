#pragma once
/// \file
/// What a figure is drawn on: lines, circles and texts in pt from the upper left corner, y downwards.

#include "plot/figure.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// A place on a canvas, in pt.
struct Place {
  double x, y;
};

/// An upright rectangle of a canvas, in pt: left < right, top < bottom.
struct Frame {
  double left, right, top, bottom;
};

/// The corners of a frame, round it from the upper left one.
inline std::vector<Place> corners(const Frame &f) {
  return {{f.left, f.top}, {f.right, f.top}, {f.right, f.bottom}, {f.left, f.bottom}};
}

/// How a shape is drawn: its inside, then its line. An empty colour: not drawn.
struct Look {
  std::string fill;
  std::string line;
  double width = 1; ///< of the line, in pt
  Stroke stroke = Stroke::solid;

  bool operator==(const Look &) const = default;
};

/// How far the middle line of letters is above the line on which they stand, in parts of their size.
inline constexpr double middle_of_letters = 0.36;

/// How a text of one line stands: its `align` end is at its place, its middle line too; upright: written
/// upwards.
struct TextLook {
  Align align = Align::left;
  double size = letter_size;
  bool upright = false;
};

/// One picture while it is drawn. What comes later covers what came before.
class Canvas {
public:
  Canvas() = default;
  Canvas(const Canvas &) = delete;
  Canvas &operator=(const Canvas &) = delete;
  virtual ~Canvas() = default;

  /// From here on nothing is drawn outside of the frame, until unclip().
  virtual void clip(const Frame &frame) = 0;
  virtual void unclip() = 0;

  /// Lines through the places of each piece; `closed`: back to its first place.
  virtual void lines(const std::vector<std::vector<Place>> &pieces, bool closed, const Look &look) = 0;
  virtual void circle(Place center, double radius, const Look &look) = 0;
  /// Black text, of UTF-8 without control characters.
  virtual void text(Place at, std::string_view text, const TextLook &look) = 0;

  /// The picture as a file's bytes. Nothing is drawn afterwards.
  virtual std::string finish() = 0;
};

} // namespace mdm
