#pragma once
/// \file
/// A trade-off as a figure.

#include "plot/figure.hpp"

#include <mdm/match/tradeoff.hpp>

namespace mdm {

/// N over the tolerance and N over the smallest sieve kept, beside this the mass lost.
Figure tradeoff_figure(const Tradeoff &t);

} // namespace mdm
