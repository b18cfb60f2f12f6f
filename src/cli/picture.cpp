#include "cli/picture.hpp"

#include "cli/child_process.hpp"
#include "cli/files.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

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

/// Cairo writes when it made a PDF; the same figure is to give the same file.
void remove_date(std::string &pdf) {
  constexpr std::string_view key = "/CreationDate (D:";
  constexpr std::string_view no_date = "19700101000000";
  const std::size_t at = pdf.find(key);
  if (at != std::string::npos && at + key.size() + no_date.size() <= pdf.size())
    pdf.replace(at + key.size(), no_date.size(), no_date);
}

} // namespace

void PictureFlags::add_to(CLI::App &command) {
  command.add_option("-o", out, "write the picture to OUT, - for standard output")->type_name("OUT");
  command.add_option("--format", format, "svg, png or pdf; else as OUT ends")
      ->check(CLI::IsMember({"svg", "png", "pdf"}));
  command.add_option("--script", script, "write the script for gnuplot to SCRIPT and draw nothing")
      ->type_name("SCRIPT");
}

Picture PictureFlags::picture() const {
  if (out.has_value() == script.has_value())
    throw InputError(
        "give -o OUT.svg (or .png, .pdf) for the picture, or --script SCRIPT for gnuplot's script");
  if (format)
    return *picture_named(*format);
  if (script)
    return Picture::svg;
  const std::optional<Picture> picture = picture_at(*out);
  if (!picture)
    throw InputError(printable(*out) + ": let OUT end in .svg, .png or .pdf, or give --format");
  return *picture;
}

std::optional<Picture> picture_at(const std::string &path) {
  const std::size_t dot = path.rfind('.');
  return picture_named(dot == std::string::npos ? "" : path.substr(dot + 1));
}

std::string run_gnuplot(const std::string &script) {
  constexpr std::chrono::minutes time_limit{2};
  constexpr std::size_t most_output = std::size_t{1} << 30;
  constexpr int not_found = 127; // the shell's exit code
  // Nothing of the picture is to depend on where it is drawn.
  ChildEnd end = run_child("TZ=UTC LC_ALL=C.UTF-8 exec gnuplot -d -", script, time_limit, most_output);
  if (end.how == ChildEnd::How::exited && end.code == not_found)
    throw InputError("gnuplot, which draws, is not found: install it (Debian, Ubuntu: apt-get install "
                     "gnuplot-nox), or ask for no picture");
  if (end.how == ChildEnd::How::timed_out)
    throw InputError("gnuplot did not end within two minutes: try again on a machine that is less busy, or "
                     "ask for no picture");
  if (end.how != ChildEnd::How::exited || end.code != 0 || end.output.empty())
    throw InputError(
        fmt::format("gnuplot failed: {}; version 5.4 or later with the svg, pngcairo and pdfcairo "
                    "terminals is needed (Debian, Ubuntu: gnuplot-nox)",
                    in_quotes(end.last_error)));
  remove_date(end.output);
  return std::move(end.output);
}

void tell_escapes(const Figure &figure) {
  for (const std::string &text : escaped_texts(figure))
    tell(fmt::format("note: {} is drawn as {}: gnuplot's fonts may lack its characters\n", in_quotes(text),
                     in_quotes(drawable(text))));
}

void draw(const Figure &figure, const PictureFlags &flags, bool quiet) {
  const std::string script = gnuplot_script(figure, flags.picture());
  Output out(flags.script ? *flags.script : *flags.out);
  out.write(flags.script ? script : run_gnuplot(script));
  out.commit();
  if (!quiet)
    tell_escapes(figure);
}

} // namespace mdm::cli
