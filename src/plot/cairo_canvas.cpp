#include "plot/cairo_canvas.hpp"

#include <mdm/text/error.hpp>

#include <cairo-pdf.h>
#include <cairo.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#include <sanitizer/lsan_interface.h>
#define MDM_KEEPS_FONTS const __lsan::ScopedDisabler keeps_fonts
#endif
#endif
#ifndef MDM_KEEPS_FONTS
#define MDM_KEEPS_FONTS static_cast<void>(0)
#endif

namespace mdm {
namespace {

// MDM_KEEPS_FONTS: the library of fonts keeps what it has read until the program ends; clang's search for
// leaks is not to count it.

constexpr double pixels_per_pt = 2;
constexpr double pi = 3.141592653589793;

cairo_status_t append(void *file, const unsigned char *data, unsigned length) {
  static_cast<std::string *>(file)->append(reinterpret_cast<const char *>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

class CairoCanvas : public Canvas {
public:
  ~CairoCanvas() override {
    cairo_destroy(cairo_);
    cairo_surface_destroy(surface_);
  }

  void clip(const Frame &frame) override {
    cairo_save(cairo_);
    cairo_rectangle(cairo_, frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
    cairo_clip(cairo_);
  }

  void unclip() override { cairo_restore(cairo_); }

  void lines(const std::vector<std::vector<Place>> &pieces, bool closed, const Look &look) override {
    for (const std::vector<Place> &piece : pieces) {
      cairo_new_sub_path(cairo_);
      for (const Place &p : piece)
        cairo_line_to(cairo_, p.x, p.y);
      if (closed)
        cairo_close_path(cairo_);
    }
    paint(look);
  }

  void circle(Place center, double radius, const Look &look) override {
    cairo_new_sub_path(cairo_);
    cairo_arc(cairo_, center.x, center.y, radius, 0, 2 * pi);
    paint(look);
  }

  void text(Place at, std::string_view text, const TextLook &look) override {
    MDM_KEEPS_FONTS;
    const std::string shown(text);
    set_color("#000000");
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, look.size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, shown.c_str(), &extents);
    static constexpr std::array<double, 3> parts = {0, 0.5, 1}; // of the width, left of the place
    cairo_save(cairo_);
    cairo_translate(cairo_, at.x, at.y);
    if (look.upright)
      cairo_rotate(cairo_, -pi / 2);
    cairo_move_to(cairo_, -parts.at(static_cast<std::size_t>(look.align)) * extents.x_advance,
                  middle_of_letters * look.size);
    cairo_show_text(cairo_, shown.c_str());
    cairo_restore(cairo_);
  }

  std::string finish() override {
    MDM_KEEPS_FONTS;
    end_page();
    const cairo_status_t status = cairo_status(cairo_);
    if (status != CAIRO_STATUS_SUCCESS)
      throw InputError(fmt::format("the picture cannot be drawn: cairo says: {}: let OUT end in .svg",
                                   cairo_status_to_string(status)));
    return std::move(file_);
  }

protected:
  /// \param surface  taken over
  void begin(cairo_surface_t *surface) {
    surface_ = surface;
    cairo_ = cairo_create(surface_);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
  }

  /// The file is complete afterwards.
  virtual void end_page() = 0;

  std::string file_;
  cairo_surface_t *surface_ = nullptr;
  cairo_t *cairo_ = nullptr;

private:
  void set_color(const std::string &color) {
    const unsigned long rgb = std::strtoul(color.c_str() + 1, nullptr, 16);
    const auto part = [rgb](unsigned shift) { return static_cast<double>((rgb >> shift) & 0xFFU) / 255; };
    cairo_set_source_rgb(cairo_, part(16), part(8), part(0));
  }

  void paint(const Look &look) {
    if (!look.fill.empty()) {
      set_color(look.fill);
      cairo_fill_preserve(cairo_);
    }
    if (!look.line.empty()) {
      static constexpr std::array<double, 2> dashed = {9, 5}, dotted = {2, 3};
      const bool is_solid = look.stroke == Stroke::solid || look.stroke == Stroke::none;
      cairo_set_dash(cairo_, look.stroke == Stroke::dashed ? dashed.data() : dotted.data(), is_solid ? 0 : 2,
                     0);
      cairo_set_line_width(cairo_, look.width);
      set_color(look.line);
      cairo_stroke_preserve(cairo_);
    }
    cairo_new_path(cairo_);
  }
};

class PngCanvas : public CairoCanvas {
public:
  PngCanvas(double width, double height) {
    const auto pixels = [](double length) {
      return static_cast<int>(std::lround(std::min(length, 1e6) * pixels_per_pt));
    };
    begin(cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels(width), pixels(height)));
    cairo_scale(cairo_, pixels_per_pt, pixels_per_pt);
    cairo_set_source_rgb(cairo_, 1, 1, 1);
    cairo_paint(cairo_);
  }

private:
  void end_page() override { cairo_surface_write_to_png_stream(surface_, append, &file_); }
};

class PdfCanvas : public CairoCanvas {
public:
  PdfCanvas(double width, double height) {
    begin(cairo_pdf_surface_create_for_stream(append, &file_, width, height));
    cairo_pdf_surface_set_metadata(surface_, CAIRO_PDF_METADATA_CREATE_DATE, "1970-01-01T00:00:00Z");
  }

private:
  void end_page() override {
    cairo_show_page(cairo_);
    cairo_surface_finish(surface_);
  }
};

} // namespace

std::unique_ptr<Canvas> png_canvas(double width, double height) {
  return std::make_unique<PngCanvas>(width, height);
}

std::unique_ptr<Canvas> pdf_canvas(double width, double height) {
  return std::make_unique<PdfCanvas>(width, height);
}

} // namespace mdm
