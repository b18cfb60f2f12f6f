#pragma once
/// \file
/// The place and the format of a command's figure.

#include "plot/picture.hpp"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace mdm::cli {

/// The options of a command that draws.
struct PictureFlags {
  std::optional<std::string> out, format;

  void add_to(CLI::App &command);

  /// The format that was asked for, or that the ending of OUT says.
  /// \throws InputError if neither says it, or OUT is not given
  Picture picture() const;
};

/// The format that the ending of `path` says; nothing if it says none.
std::optional<Picture> picture_at(const std::string &path);

/// Says on standard error which texts of the figure are not drawn as they are.
void tell_escapes(const Figure &figure);

/// Draws the figure to OUT; all of it or no file. Unless `quiet`, tells what is escaped.
/// \throws InputError as PictureFlags::picture() and picture_of()
void draw(const Figure &figure, const PictureFlags &flags, bool quiet);

} // namespace mdm::cli
