#include "plot/picture.hpp"

#include "plot/cairo_canvas.hpp"
#include "plot/figure_layout.hpp"
#include "plot/palette.hpp"
#include "plot/panel_painter.hpp"
#include "plot/svg_canvas.hpp"

namespace mdm {
namespace {

std::unique_ptr<Canvas> canvas_of(Picture picture, const Figure &figure, const FigureLayout &layout) {
  switch (picture) {
  case Picture::png:
    return png_canvas(layout.width, layout.height);
  case Picture::pdf:
    return pdf_canvas(layout.width, layout.height);
  case Picture::svg:
    break;
  }
  return svg_canvas(layout.width, layout.height, drawable(figure.title), drawable(figure.description));
}

void paint_legend(Canvas &canvas, const FigureLayout &layout) {
  const double left = layout.legend_place.x;
  double y = layout.legend_place.y + line_height / 2;
  for (const Series *s : layout.legend) {
    paint_legend_sample(canvas, *s, left, left + legend_sample, y);
    const double room = layout.width - left - legend_sample - 2 * text_gap;
    canvas.text({left + legend_sample + text_gap, y}, fitted(legend_title(*s), room), {});
    y += line_height;
  }
}

/// The bar of the colours with its scale, least value at the bottom unless the axis is reversed.
void paint_color_bar(Canvas &canvas, const FigureLayout &layout, const Axis &colors) {
  const Frame &bar = layout.colors;
  constexpr int slices = 128;
  const double height = bar.bottom - bar.top;
  for (int i = 0; i < slices; ++i) {
    // Each reaches up to the top, so that no light shines between two.
    const double from = bar.bottom - height * i / slices;
    canvas.lines({corners({bar.left, bar.right, bar.top, from})}, true,
                 {palette_color((i + 0.5) / slices), "", 0, Stroke::solid});
  }
  const Look line{"", "#000000", 1, Stroke::solid};
  canvas.lines({corners(bar)}, true, line);
  for (const Tick &t : colors.ticks) {
    const double share = (t.at - colors.low) / colors.span();
    const double y = bar.bottom - height * (colors.reversed ? 1 - share : share);
    canvas.lines({{{bar.right, y}, {bar.right + tick_length, y}}}, false, line);
    canvas.text({bar.right + tick_length + text_gap / 2, y}, drawable(t.label), {});
  }
  canvas.text({layout.colors_title, (bar.top + bar.bottom) / 2}, drawable(colors.title),
              {Align::center, letter_size, true});
}

} // namespace

std::string picture_of(const Figure &figure, Picture picture) {
  const FigureLayout layout(figure);
  const std::unique_ptr<Canvas> canvas = canvas_of(picture, figure, layout);
  const double left = layout.around.left;
  if (has_title(figure))
    canvas->text({left, title_size}, fitted(figure.title, layout.width - left - text_gap, title_size),
                 {Align::left, title_size, false});
  const double room = figure.panel_width + layout.around.left + layout.around.right;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    paint_panel(*canvas, figure.panels[i], layout.panels[i], room, figure.colors ? &*figure.colors : nullptr);
  paint_legend(*canvas, layout);
  for (std::size_t i = 0; i < layout.notes.size(); ++i)
    canvas->text(layout.note_places[i], layout.notes[i], {});
  for (std::size_t i = 0; i < layout.remarks.size(); ++i)
    canvas->text(layout.remark_places[i], layout.remarks[i], {});
  if (figure.colors)
    paint_color_bar(*canvas, layout, *figure.colors);
  return canvas->finish();
}

} // namespace mdm
