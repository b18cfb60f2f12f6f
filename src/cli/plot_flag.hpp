#pragma once
/// \file
/// --plot of commands whose answer is a report.

#include "files/output.hpp"
#include "plot/figure.hpp"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>

namespace mdm::cli {

struct PlotFlag {
  std::optional<std::string> out;

  /// \param help completed by "into OUT.svg, .png or .pdf"
  void add_to(CLI::App &command, const std::string &help);
  /// `-` where there is none, for check_distinct.
  std::string path() const { return out.value_or("-"); }
  explicit operator bool() const { return out.has_value(); }

  /// \throws InputError if it is standard output, or ends as no picture does
  void check() const;
  /// The picture, written but not committed yet, so that it appears with the report or not at all. Unless
  /// `quiet`, tells what is escaped. \pre it is given
  std::unique_ptr<Output> drawn(const Figure &figure, bool quiet) const;
};

} // namespace mdm::cli
