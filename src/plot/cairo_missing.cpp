// In place of cairo_canvas.cpp where cairo is not found.

#include "plot/cairo_canvas.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

[[noreturn]] void refuse(const char *format) {
  throw InputError(
      std::string(format) +
      ": this mdm was built without cairo, which draws it (Debian: libcairo2-dev): let OUT end in .svg");
}

} // namespace

std::unique_ptr<Canvas> png_canvas(double /*width*/, double /*height*/) {
  refuse("PNG");
}

std::unique_ptr<Canvas> pdf_canvas(double /*width*/, double /*height*/) {
  refuse("PDF");
}

} // namespace mdm
