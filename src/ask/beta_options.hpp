#pragma once
/// \file
/// The options of a beta curve, which generate and pack share.

#include "ask/option_row.hpp"
#include "sets/beta_curve.hpp"

#include <memory>
#include <string>

namespace mdm {

/// --beta and the sizes of its curve, as they were given.
struct BetaTexts {
  OptionText beta, d_min, d_max, span, ratio;
};

/// `mm` where sizes have units; empty where they have none. \throws InputError if one alone has
std::string beta_unit(const BetaTexts &c);

/// The curve, with sizes in mm where they have units. \throws InputError naming the option
std::shared_ptr<const BetaCurve> beta_curve(const BetaTexts &c);

} // namespace mdm
