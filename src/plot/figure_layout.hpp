#pragma once
/// \file
/// Where the parts of a figure stand on its page.

#include "plot/canvas.hpp"
#include "plot/figure_form.hpp"

#include <vector>

namespace mdm {

inline constexpr double title_size = 13;
inline constexpr double line_height = 1.35 * letter_size;
inline constexpr double text_gap = 6;
inline constexpr double tick_length = 5;
inline constexpr double color_bar_width = 14;
inline constexpr double legend_sample = 34; ///< width of the sample of a line in the legend

/// The room around a panel's frame, in pt.
struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0;
};

/// What the panel needs for its titles, labels and strips.
Margins margins(const Panel &panel);

/// From the panel's frame down to the lower end of its labels of x.
double below_ticks(const Panel &panel);

/// True if its title is drawn.
bool has_title(const Figure &figure);

/// The width of the figure's panels in a picture of `width`, and 100 at least: beside them stand their
/// labels.
double panel_width_in(double width, const Figure &figure);

/// Lets two panels stand side by side, or in a narrow picture one below the other, as large as they may be.
/// \pre the panels are there, as their labels take room
/// \param height  of each, in pt, where there is room
void set_two_panels(Figure &figure, double height, const FigureForm &form);

/// The title of a series, cut to the legend's room.
std::string legend_title(const Series &series);

/// The page of a figure: panels in a grid; below it the legend and at its right the notes in columns, or
/// beside it the colour bar, the legend and the notes; below all of it the remarks. All places are in pt, y
/// downwards.
struct FigureLayout {
  /// \param figure  is kept by reference to its series
  explicit FigureLayout(const Figure &figure);

  double width = 0, height = 0;
  Margins around;                     ///< of every panel
  std::vector<Frame> panels;          ///< their frames, without labels
  std::vector<const Series *> legend; ///< the first series of each title
  Place legend_place{};               ///< upper left corner of its first line
  std::vector<std::string> notes;     ///< as they are shown
  std::vector<Place> note_places;     ///< left ends of their middle lines
  std::vector<std::string> remarks;   ///< in lines
  std::vector<Place> remark_places;
  Frame colors{};          ///< the colour bar, where there is one
  double colors_title = 0; ///< x of its title
};

} // namespace mdm
