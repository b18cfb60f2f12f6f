#include "ask/soil_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {

const std::vector<OptionRow<SoilTexts>> SoilTexts::options = {
    {"liquid-limit", "LL", OptionKind::number,
     "of the fines, in percent; without limits they are low-plasticity silt", &SoilTexts::liquid_limit},
    {"plastic-limit", "PL", OptionKind::number, "of the fines, in percent", &SoilTexts::plastic_limit},
    {"pan-size", "SIZE", OptionKind::number, "take the pan as a sieve of this size", &SoilTexts::pan_size},
    {"extrapolate", "", OptionKind::flag,
     "continue the line through the two finest sieves into a pan at size 0", &SoilTexts::extrapolate}};

DescribeOptions SoilTexts::describe_options() const {
  if (liquid_limit.has_value() != plastic_limit.has_value())
    throw InputError(option("liquid-limit") + " and " + option("plastic-limit") +
                     " go together: give both, or neither for silt");
  DescribeOptions o;
  o.extrapolate = extrapolate;
  if (liquid_limit) {
    o.limits =
        AtterbergLimits{number("liquid-limit", *liquid_limit), number("plastic-limit", *plastic_limit)};
    classify_fines(*o.limits);
  }
  return o;
}

Gradation SoilTexts::with_pan(const Gradation &g) const {
  if (extrapolate && pan_size)
    throw InputError(option("extrapolate") + " is for a pan at size 0, and " + option("pan-size") +
                     " gives it another: leave one of them out");
  if (extrapolate && !g.has_pan())
    throw InputError(option("extrapolate") +
                     ": there is no pan, nothing passes the finest sieve: leave it out");
  return pan_size ? g.with_pan_size(length("pan-size", *pan_size).in(g)) : g;
}

} // namespace mdm
