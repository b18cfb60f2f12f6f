#pragma once
/// \file
/// What the user asks mdm plot for, and what all its pictures have in common.

#include "ask/plot.hpp"
#include "cli/output_flags.hpp"
#include "cli/picture.hpp"
#include "cli/reading_flags.hpp"
#include "cli/soil_flags.hpp"

#include <string>
#include <vector>

namespace mdm::cli {

struct PlotCommand {
  std::string file;
  std::vector<std::string> beside; ///< other gradations on the same chart
  PlotTexts asked;
  OutputFlags output;
  PictureFlags picture;
  SoilFlags soil;
  ReadingFlags reading;
};

/// The band in the file, in which there is a curve. \throws InputError if there is none
Envelope band_with_curve(const std::string &file);

/// Draws the figure, with the caption added.
int draw_figure(const PlotCommand &c, Figure figure);

} // namespace mdm::cli
