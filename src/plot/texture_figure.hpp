#pragma once
/// \file
/// The triangle of a classification of textures, with gradations as points in it.

#include "plot/figure.hpp"
#include "plot/figure_form.hpp"
#include "soil/texture.hpp"

namespace mdm {

/// A gradation among others.
struct NamedCurve {
  std::string name; ///< in the legend
  GradingCurve curve;
};

/// The fields of the system with their names, and of each curve a point with what texture() says of it in the
/// legend; of one that has no texture a remark says why.
Figure texture_figure(TextureSystem system, const std::vector<NamedCurve> &curves, const FigureForm &form);

} // namespace mdm
