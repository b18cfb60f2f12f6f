#pragma once
/// \file
/// Limits of percent passing in a figure.

#include "plot/figure.hpp"

#include <mdm/gradation/envelope.hpp>

namespace mdm {

/// The area between the limits, which has the title, and both of its edges; over the size in units of
/// `unit_mm` mm, in log10. A limit at size 0 is left out.
std::vector<Series> limits_series(const Envelope &limits, const Rational &unit_mm, const std::string &title);

} // namespace mdm
