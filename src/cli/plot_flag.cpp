#include "cli/plot_flag.hpp"

#include "cli/picture.hpp"
#include "files/paths.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {

void PlotFlag::add_to(CLI::App &command, const std::string &help) {
  command.add_option("--plot", out, help + " into OUT.svg, .png or .pdf")->type_name("OUT");
}

void PlotFlag::check() const {
  if (out == "-")
    throw InputError(option("plot") + " needs a file: standard output has the report");
  if (out && !picture_at(*out))
    throw InputError(option("plot") + ": " + printable(*out) + ": let OUT end in .svg, .png or .pdf");
  if (out)
    refuse_protected(*out);
}

std::unique_ptr<Output> PlotFlag::drawn(const Figure &figure, bool quiet) const {
  auto picture = std::make_unique<Output>(*out);
  picture->write(picture_of(figure, *picture_at(*out)));
  if (!quiet)
    tell_escapes(figure);
  return picture;
}

} // namespace mdm::cli
