#include "ask/beta_options.hpp"

#include "ask/option_values.hpp"

#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// In mm where it has a unit.
Rational beta_end(const std::string &name, const std::string &text) {
  return length(name, text).in(SizeUnit::mm);
}

/// The ends of the curve from two of the four options (Eq. 17).
std::pair<Rational, Rational> beta_ends(const BetaTexts &c) {
  const int given = c.d_min.has_value() + c.d_max.has_value() + c.span.has_value() + c.ratio.has_value();
  if (given != 2 || (!c.d_min && !c.d_max))
    throw InputError(option("beta") + ": two sizes are needed: " + option("dmin") + " and " + option("dmax") +
                     ", or one of them with " + option("span") + " or " + option("ratio"));
  if (c.d_min && c.d_max)
    return {beta_end("dmin", *c.d_min), beta_end("dmax", *c.d_max)};
  Rational r;
  if (c.span) {
    const Rational s = positive("span", *c.span);
    if (s >= 1)
      throw InputError(option("span") + ": " + in_quotes(*c.span) + " is not below 1: then d_min would be 0");
    r = (1 + s) / (1 - s);
  } else {
    r = positive("ratio", *c.ratio);
    if (r <= 1)
      throw InputError(option("ratio") + ": " + in_quotes(*c.ratio) +
                       " is not above 1: d_max / d_min is needed");
  }
  if (c.d_min) {
    const Rational low = beta_end("dmin", *c.d_min);
    return {low, low * r};
  }
  const Rational high = beta_end("dmax", *c.d_max);
  return {high / r, high};
}

} // namespace

std::string beta_unit(const BetaTexts &c) {
  const bool low = c.d_min && length("dmin", *c.d_min).unit, high = c.d_max && length("dmax", *c.d_max).unit;
  if (c.d_min && c.d_max && low != high)
    throw InputError(option("dmin") + " and " + option("dmax") +
                     ": one has a unit and one has none: give both a unit, or neither");
  return low || high ? "mm" : "";
}

std::shared_ptr<const BetaCurve> beta_curve(const BetaTexts &c) {
  const std::size_t comma = c.beta->find(',');
  if (comma == std::string::npos)
    throw InputError(option("beta") + ": " + in_quotes(*c.beta) + " is not A,B: write for example 1,3");
  const Rational a = positive("beta", c.beta->substr(0, comma)),
                 b = positive("beta", c.beta->substr(comma + 1));
  const auto [low, high] = beta_ends(c);
  return named("beta", *c.beta, [&, l = low, h = high](const std::string &) {
    return std::make_shared<const BetaCurve>(a, b, l, h);
  });
}

} // namespace mdm
