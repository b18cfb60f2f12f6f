#pragma once
/// \file
/// The picture of one gradation, with particles where there are some.

#include "cli/plot_command.hpp"

namespace mdm::cli {

/// \param is_sample  FILE has particles, whose curve is drawn
/// \param content  of FILE, where it has none
int plot_gradation(const PlotCommand &c, bool is_sample, const std::string &content);

} // namespace mdm::cli
