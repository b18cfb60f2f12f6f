#pragma once
/// \file
/// A triaxial test as a picture.

#include "plot/figure.hpp"
#include "plot/figure_form.hpp"
#include "report/triaxial_log.hpp"

namespace mdm {

/// The deviator stress q and the volumetric strain over the axial strain, in two panels, and below them the
/// constant stress.
Figure triaxial_figure(const std::string &title, const TriaxialLog &log, const FigureForm &form);

} // namespace mdm
