#pragma once
/// \file
/// The figure of several gradations on one chart, with limits.

#include "plot/figure.hpp"
#include "plot/figure_form.hpp"

#include <mdm/gradation/envelope.hpp>
#include <mdm/gradation/gradation.hpp>

#include <optional>

namespace mdm {

/// A curve among others.
struct DrawnCurve {
  enum class Weight {
    thin,  ///< what something is made of
    thick, ///< what the figure is about
    dashed ///< what is aimed at
  };
  std::string name; ///< in the legend
  Gradation gradation;
  Weight weight = Weight::thick;
  std::vector<Rational> missed = {}; ///< sizes in mm that are marked: a limit is missed there
};

/// The contents of a figure.
struct CurvesFigure {
  std::string title;
  std::vector<DrawnCurve> curves; ///< at least one
  std::optional<Envelope> limits;
  FigureForm form;
};

/// The curves through their sieves, percent passing over log size in mm; below a finest sieve above a pan at
/// 0 a curve is not known, and ends. Each has a colour of its own, from the ninth on a stroke too.
Figure curves_figure(const CurvesFigure &what);

} // namespace mdm
