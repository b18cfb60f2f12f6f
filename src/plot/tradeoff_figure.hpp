#pragma once
/// \file
/// A trade-off as a figure.

#include "match/tradeoff.hpp"
#include "plot/figure.hpp"

namespace mdm {

/// N over the tolerance and N over the smallest sieve kept, beside this the mass lost.
Figure tradeoff_figure(const Tradeoff &t);

} // namespace mdm
