// Sizes of particles drawn in one class by inverse sampling. What comes in is a number y in (0, 1), of
// Philox or in equal steps; what goes out are decimals around F^-1(y), inside the class. Sizes that 64-bit
// integers decide come from quick_sizes.cpp. Else F^-1, which grows with both bounds of the class, is
// enclosed at the bounds rounded down and rounded up; digits are added until the enclosure lies inside the
// class.

#include "sets/set_sizes.hpp"

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// Digits of bounds beyond those of sizes: enough for y as near to 0 and 1 as it can be drawn.
constexpr unsigned more_digits = 45;

Interval around(const Real &y, unsigned digits) {
  if (y.fraction())
    return *y.fraction();
  const Enclosure e = enclose(y, digits + more_digits);
  return {e.lower(), e.upper()};
}

/// A decimal that is longer than `digits` as an enclosure of that length.
Enclosure cut(const Enclosure &e, unsigned digits) {
  const auto length = static_cast<unsigned>(to_string(e.lo).size());
  if (e.lo != e.hi || length <= digits || e.places == 0)
    return e;
  const unsigned less = std::min(length - digits, e.places);
  const Integer lo = floor_div(e.lo, power_of_ten(less));
  return {lo, Integer(lo + 1), e.places - less};
}

} // namespace

ClassSizes::ClassSizes(const SizeClass &c, unsigned dimension, unsigned digits)
    : greatest_lower_(around(c.lower.real, digits).hi), least_upper_(around(c.upper.real, digits).lo),
      below_(around(c.lower.real, digits).lo, least_upper_, dimension),
      above_(greatest_lower_, around(c.upper.real, digits).hi, dimension),
      exact_(c.lower.real.fraction() && c.upper.real.fraction()), digits_(digits),
      quick_(around(c.lower.real, digits), around(c.upper.real, digits), dimension, digits) {}

Enclosure ClassSizes::at(const Rational &y) const {
  const auto enclose = [&](unsigned digits) {
    Enclosure e = cut(below_.size(y, digits), digits);
    if (!exact_) {
      const Enclosure above = above_.size(y, digits);
      const unsigned places = std::max(e.places, above.places);
      e = {e.lo * power_of_ten(places - e.places), above.hi * power_of_ten(places - above.places), places};
    }
    return e;
  };
  const auto is_inside = [&](const Enclosure &e) {
    return e.lower() > greatest_lower_ && e.upper() <= least_upper_;
  };
  Enclosure e = enclose(digits_);
  for (unsigned digits = digits_ + 8; !is_inside(e) && (exact_ || digits <= digits_ + more_digits);
       digits += 8)
    e = enclose(digits);
  return e;
}

std::optional<Rational> ClassSizes::exact(const Rational &y) const {
  if (!has_fractions())
    return std::nullopt;
  return below_.powered_size(y);
}

Rational Draws::operator()(std::uint64_t j, std::uint64_t i, const Integer &q) const {
  if (!philox_)
    return ratio(2 * Integer(i) + 1, 2 * q);
  return ratio(2 * Integer((*philox_)(j, i)) + 1, Integer(1) << 65);
}

std::uint64_t Draws::bits(std::uint64_t j, std::uint64_t i, std::uint64_t q) const {
  assert(philox_ || i < q);
  if (philox_)
    return (*philox_)(j, i);
  __extension__ typedef unsigned __int128 Product;
  return static_cast<std::uint64_t>(((Product{2} * i + 1) << 63) / q);
}

ParticlesOf drawn_particles(const std::vector<SizeClass> &classes, const std::vector<Integer> &numbers,
                            unsigned dimension, unsigned digits, const Draws &draws) {
  return [=](std::size_t j, const TakeSize &take) {
    if (numbers[j] == 0)
      return;
    const ClassSizes sizes(classes[j], dimension, digits);
    const auto q = static_cast<std::uint64_t>(numbers[j]);
    for (std::uint64_t i = 0; i < q; ++i)
      if (const std::optional<ShortSize> size = sizes.quick(draws.bits(j, i, q)))
        take({size->lo, Integer(size->lo) + 1, size->places}, 1);
      else
        take(sizes.at(draws(j, i, numbers[j])), 1);
  };
}

} // namespace mdm
