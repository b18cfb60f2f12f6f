#include <mdm/grading/set_sizes.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// Digits of bounds beyond those of sizes: enough for y as near to 0 and 1 as it can be drawn.
constexpr unsigned more_digits = 45;

struct Bounds {
  Rational lo, hi;
};

Bounds around(const Real &y, unsigned digits) {
  if (y.fraction())
    return {*y.fraction(), *y.fraction()};
  const Enclosure e = enclose(y, digits + more_digits);
  return {e.lower(), e.upper()};
}

} // namespace

ClassSizes::ClassSizes(const SizeClass &c, unsigned dimension, unsigned digits)
    : greatest_lower_(around(c.lower.real, digits).hi), least_upper_(around(c.upper.real, digits).lo),
      below_(around(c.lower.real, digits).lo, least_upper_, dimension),
      above_(greatest_lower_, around(c.upper.real, digits).hi, dimension),
      exact_(c.lower.real.fraction() && c.upper.real.fraction()), digits_(digits) {}

Enclosure ClassSizes::at(const Rational &y) const {
  const auto enclose = [&](unsigned digits) {
    Enclosure e = below_.size(y, digits);
    if (!exact_) {
      const Enclosure above = above_.size(y, digits);
      const unsigned places = std::max(e.places, above.places);
      e = {e.lo * power_of_ten(places - e.places), above.hi * power_of_ten(places - above.places), places};
    }
    return e;
  };
  Enclosure e = enclose(digits_);
  for (unsigned digits = digits_ + 8;
       digits <= digits_ + more_digits && (e.lower() < greatest_lower_ || e.upper() > least_upper_);
       digits += 8)
    e = enclose(digits);
  return e;
}

std::optional<Rational> ClassSizes::exact(const Rational &y) const {
  if (!exact_ || below_.power() != 1)
    return std::nullopt;
  return below_.powered_size(y);
}

Rational Draws::operator()(std::uint64_t j, std::uint64_t i, const Integer &q) const {
  if (!philox_)
    return ratio(2 * Integer(i) + 1, 2 * q);
  return ratio(2 * Integer((*philox_)(j, i)) + 1, Integer(1) << 65);
}

} // namespace mdm
