#pragma once
/// \file
/// A sample over time as a picture.

#include "plot/figure.hpp"
#include "report/timesteps_report.hpp"

namespace mdm {

/// Panels over the timesteps, each where there is something to show: the largest error of a share and the
/// fines lost; the coordination; void ratio and segregation; relative breakage.
/// \throws InputError if there is one timestep alone
Figure timesteps_figure(const TimestepsReport &r);

} // namespace mdm
