#include "plot/figure_layout.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace mdm {
namespace {

constexpr double widest_note = 300;

/// Text as wide as the widest label.
double widest(const std::vector<Tick> &ticks) {
  double width = 0;
  for (const Tick &t : ticks)
    width = std::max(width, text_width(t.label, letter_size));
  return width;
}

double widest_legend(const std::vector<const Series *> &legend) {
  double width = 0;
  for (const Series *s : legend)
    width = std::max(width, legend_sample + 2 * text_gap + text_width(legend_title(*s), letter_size));
  return width;
}

double widest_text(const std::vector<std::string> &texts) {
  double width = 0;
  for (const std::string &text : texts)
    width = std::max(width, text_width(text, letter_size));
  return width;
}

std::vector<const Series *> titled_series(const Figure &figure) {
  std::vector<const Series *> all;
  std::set<std::string> titles;
  for (const Panel &p : figure.panels)
    for (const Series &s : p.series)
      if (!s.title.empty() && titles.insert(s.title).second)
        all.push_back(&s);
  return all;
}

Margins common_margins(const std::vector<Panel> &panels) {
  Margins all;
  for (const Panel &p : panels) {
    const Margins m = margins(p);
    all = {std::max(all.left, m.left), std::max(all.right, m.right), std::max(all.top, m.top),
           std::max(all.bottom, m.bottom)};
  }
  return all;
}

double lines(std::size_t n) {
  return line_height * static_cast<double>(n);
}

/// The colour bar, and beside it the legend above the notes. \pre the panels stand, and fill `layout`
void place_beside(FigureLayout &layout, const Axis &colors, double top) {
  const double left = layout.width;
  layout.colors = {left, left + color_bar_width, layout.panels.front().top, layout.panels.back().bottom};
  const double side = layout.colors.right + tick_length + widest(colors.ticks) + line_height + 3 * text_gap;
  layout.colors_title = side - 2 * text_gap - line_height / 2;
  layout.legend_place = {side, top + text_gap};
  double y = layout.legend_place.y + line_height / 2;
  if (!layout.legend.empty())
    y += lines(layout.legend.size() + 1);
  for (std::size_t i = 0; i < layout.notes.size(); ++i)
    layout.note_places.push_back({side, y + lines(i)});
  const double texts = std::max(widest_legend(layout.legend), widest_text(layout.notes));
  layout.width = std::ceil(side + (texts > 0 ? texts + 3 * text_gap : 0));
  layout.height = std::ceil(
      std::max(layout.height, top + 2 * text_gap + lines(layout.legend.size() + layout.notes.size() + 1)));
}

/// The legend below the panels, and at its right the notes in columns. \pre the panels stand, and fill
/// `layout`
void place_below(FigureLayout &layout) {
  const double note_width = widest_text(layout.notes) + 3 * text_gap;
  const double notes_left =
      layout.around.left + (layout.legend.empty() ? 0 : widest_legend(layout.legend) + 3 * text_gap);
  layout.width = std::ceil(std::max(layout.width, notes_left + (layout.notes.empty() ? 0 : note_width)));
  const auto columns =
      static_cast<std::size_t>(std::max(1.0, std::floor((layout.width - notes_left) / note_width)));
  const std::size_t rows = std::max(layout.legend.size(), (layout.notes.size() + columns - 1) / columns);
  const double top = layout.height;
  layout.legend_place = {layout.around.left, top};
  for (std::size_t i = 0; i < layout.notes.size(); ++i)
    layout.note_places.push_back(
        {notes_left + note_width * static_cast<double>(i / rows), top + line_height / 2 + lines(i % rows)});
  layout.height = std::ceil(top + (rows == 0 ? 0 : text_gap + lines(rows)));
}

/// The remarks below all else. \pre that stands, and fills `layout`
void place_remarks(FigureLayout &layout, const std::vector<std::string> &remarks) {
  for (const std::string &remark : remarks)
    for (std::string &line : wrapped(remark, layout.width - layout.around.left - text_gap))
      layout.remarks.push_back(std::move(line));
  if (layout.remarks.empty())
    return;
  const double top = layout.height + line_height / 2;
  for (std::size_t i = 0; i < layout.remarks.size(); ++i)
    layout.remark_places.push_back({layout.around.left, top + lines(i)});
  layout.height = std::ceil(layout.height + text_gap + lines(layout.remarks.size()));
}

} // namespace

double below_ticks(const Panel &panel) {
  return tick_length + text_gap + (panel.x.on_the_tilt ? widest(panel.x.ticks) : line_height);
}

Margins margins(const Panel &p) {
  const double title = line_height + text_gap;
  Margins m;
  m.left = title + widest(p.y.ticks) + tick_length + 2 * text_gap;
  m.right = p.right.empty() ? 3 * text_gap : title + widest(p.right) + tick_length + 2 * text_gap;
  m.top =
      text_gap + (p.title.empty() ? 0 : title) + (p.top.empty() ? 0 : widest(p.top) + tick_length + text_gap);
  m.bottom = below_ticks(p) + lines(p.strips.size()) + title + text_gap;
  return m;
}

bool has_title(const Figure &figure) {
  return !figure.title.empty() && !figure.bare;
}

double panel_width_in(double width, const Figure &figure) {
  constexpr double least = 100;
  const Margins around = common_margins(figure.panels);
  return std::max(least, width / static_cast<double>(figure.columns) - around.left - around.right);
}

void set_two_panels(Figure &figure, double height, const FigureForm &form) {
  constexpr double narrow = 700;
  figure.panel_width = 430;
  figure.panel_height = height;
  figure.columns = form.width > 0 && form.width < narrow ? 1 : 2;
  if (form.width == 0)
    return;
  figure.panel_width = panel_width_in(form.width, figure);
  figure.panel_height = std::min(figure.panel_height, std::max(210.0, 0.7 * figure.panel_width));
}

std::string legend_title(const Series &series) {
  return fitted(series.title, widest_note - legend_sample - 2 * text_gap);
}

FigureLayout::FigureLayout(const Figure &figure)
    : around(common_margins(figure.panels)), legend(titled_series(figure)) {
  if (!figure.bare)
    for (const std::string &note : figure.notes)
      notes.push_back(fitted(note, widest_note));
  const double top = has_title(figure) ? 2 * title_size : 0;
  const double cell_width = around.left + figure.panel_width + around.right;
  const double cell_height = around.top + figure.panel_height + around.bottom;
  for (std::size_t i = 0; i < figure.panels.size(); ++i) {
    const double left = static_cast<double>(i % figure.columns) * cell_width + around.left;
    const double upper = top + static_cast<double>(i / figure.columns) * cell_height + around.top;
    panels.push_back({left, left + figure.panel_width, upper, upper + figure.panel_height});
    width = std::max(width, panels.back().right + around.right);
    height = panels.back().bottom + around.bottom;
  }
  if (figure.colors)
    place_beside(*this, *figure.colors, top);
  else
    place_below(*this);
  if (!figure.bare)
    place_remarks(*this, figure.remarks);
}

} // namespace mdm
