#include "cli/picture.hpp"

#include "files/output.hpp"
#include "files/standard_streams.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm::cli {
namespace {

std::optional<Picture> picture_named(std::string_view name) {
  if (name == "svg")
    return Picture::svg;
  if (name == "png")
    return Picture::png;
  if (name == "pdf")
    return Picture::pdf;
  return std::nullopt;
}

} // namespace

void PictureFlags::add_to(CLI::App &command) {
  command.add_option("-o", out, "write the picture to OUT, - for standard output")->type_name("OUT");
  command.add_option("--format", format, "svg, png or pdf; else as OUT ends")
      ->check(CLI::IsMember({"svg", "png", "pdf"}));
}

Picture PictureFlags::picture() const {
  if (!out)
    throw InputError("the picture needs a place: give -o OUT.svg (or .png, .pdf)");
  if (format)
    return *picture_named(*format);
  const std::optional<Picture> picture = picture_at(*out);
  if (!picture)
    throw InputError(printable(*out) + ": let OUT end in .svg, .png or .pdf, or give " + option("format"));
  return *picture;
}

std::optional<Picture> picture_at(const std::string &path) {
  const std::size_t dot = path.rfind('.');
  return picture_named(dot == std::string::npos ? "" : path.substr(dot + 1));
}

void tell_escapes(const Figure &figure) {
  for (const std::string &text : escaped_texts(figure))
    tell(fmt::format("note: {} is drawn as {}: fonts may lack its characters\n", in_quotes(text),
                     in_quotes(drawable(text))));
}

void draw(const Figure &figure, const PictureFlags &flags, bool quiet) {
  write_output(*flags.out, picture_of(figure, flags.picture()));
  if (!quiet)
    tell_escapes(figure);
}

} // namespace mdm::cli
