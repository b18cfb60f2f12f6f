#pragma once
/// \file
/// A trade-off as a figure.

#include "plot/figure.hpp"
#include "plot/figure_form.hpp"
#include "report/tradeoff_reader.hpp"

namespace mdm {

/// N over the tolerance and N over the smallest sieve kept, beside this the mass lost; in a narrow picture
/// one below the other.
/// \throws InputError if a curve has no row with a match
Figure tradeoff_figure(const StatedTradeoff &t, const FigureForm &form = {});
inline Figure tradeoff_figure(const Tradeoff &t) {
  return tradeoff_figure(stated(t));
}

} // namespace mdm
