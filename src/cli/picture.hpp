#pragma once
/// \file
/// The place of a command's figure, and the program that draws it.

#include "plot/gnuplot_script.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// The options of a command that draws.
struct PictureFlags {
  std::optional<std::string> out, script, format;

  void add_to(CLI::App &command);

  /// The format that was asked for, or that the ending of OUT says.
  /// \throws InputError if neither says it, or OUT and SCRIPT are both or neither given
  Picture picture() const;
};

/// The format that the ending of `path` says; nothing if it says none.
std::optional<Picture> picture_at(const std::string &path);

/// Runs gnuplot; returns the picture. No date is left in it. Cost: some 0.1 s.
/// \throws InputError if gnuplot is missing or fails
std::string run_gnuplot(const std::string &script);

/// Says on standard error which texts of the figure are not drawn as they are.
void tell_escapes(const Figure &figure);

/// Draws the figure to OUT, or writes its script to SCRIPT; all of it or no file. Unless `quiet`, tells what
/// is escaped.
/// \throws InputError as picture() and run_gnuplot()
void draw(const Figure &figure, const PictureFlags &flags, bool quiet);

} // namespace mdm::cli
