// The lattice of a deposit: the finest decimal unit in which the width of the box and the greatest height
// that a deposit can have are below 2^52 units, so that doubles hold all places exactly. No deposit is
// higher than 4/3 of the area of its discs by the width, and four of the largest discs: it fills more than
// 0.6 of its box. The smallest disc must have 2^24 units, so that gaps of a few units do not count.

#include "packing/lattice.hpp"

#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm::packing {
namespace {

const Integer &most_units() {
  static const Integer most = Integer(1) << 52;
  return most;
}

Rational value(const DiscSize &size) {
  return ratio(Integer(size.digits), power_of_ten(size.places));
}

bool is_smaller(const DiscSize &a, const DiscSize &b) {
  __extension__ typedef unsigned __int128 Power;
  Power m = a.digits, n = b.digits;
  // Sizes have up to 18 digits; powers of ten beyond decide by themselves.
  constexpr unsigned most = 19;
  const unsigned up_a = b.places > a.places ? b.places - a.places : 0;
  const unsigned up_b = a.places > b.places ? a.places - b.places : 0;
  if (up_a > most || up_b > most)
    return up_a < up_b;
  for (unsigned i = 0; i < up_a; ++i)
    m *= 10;
  for (unsigned i = 0; i < up_b; ++i)
    n *= 10;
  return m < n;
}

/// Sum of d^2.
Rational sum_of_squares(const std::vector<DiscSize> &sizes) {
  unsigned places = 0;
  for (const DiscSize &d : sizes)
    places = std::max(places, d.places);
  Integer sum = 0;
  for (const DiscSize &d : sizes) {
    const Integer n = Integer(d.digits) * power_of_ten(places - d.places);
    sum += n * n;
  }
  return ratio(sum, power_of_ten(2 * places));
}

/// floor(y 10^places).
Integer in_units(const Rational &y, unsigned places) {
  return floor(Rational(y * Rational(power_of_ten(places))));
}

/// The square of a box's width that is about as wide as its deposit is high.
Rational squared_width(const DiscSizes &sizes) {
  return sum_of_squares(sizes.sizes) * ratio(15, 16);
}

/// As fine as a width is known where there is no lattice yet.
constexpr unsigned width_digits = 18;

} // namespace

Rational square_width(const DiscSizes &sizes) {
  return ratio(floor_root(in_units(squared_width(sizes), 2 * width_digits), 2) + 1,
               power_of_ten(width_digits));
}

Lattice lattice(const DiscSizes &sizes, const std::optional<Rational> &width) {
  if (sizes.sizes.empty())
    throw InputError("no disc to pack: give at least one size");
  const auto [least, greatest] = std::minmax_element(sizes.sizes.begin(), sizes.sizes.end(), is_smaller);
  const Rational largest = value(*greatest), smallest = value(*least);
  const Rational squares = sum_of_squares(sizes.sizes);
  // Its root is taken on the lattice.
  const Rational square = squared_width(sizes);
  const Rational least_width = 3 * largest;
  if (width ? *width < least_width : square < least_width * least_width)
    throw InputError(width ? option("width") + ": the box is narrower than 3 of the largest discs: make it " +
                                 approximate(least_width, 6) + " wide or more"
                           : "the discs are too few: a square box would be narrower than 3 of the largest: "
                             "take more discs, or give a width of " +
                                 approximate(least_width, 6) + " or more");
  const Rational wide = width ? *width : square_width(sizes);
  // Discs that rest on each other fill more than 0.6 of a box; pi / 4 is below 4/5.
  const Rational high = squares * ratio(4, 5) / (wide * ratio(3, 5)) + 4 * largest;
  const Rational most = std::max(wide, high);
  unsigned places = 0;
  while (in_units(most, places + 1) < most_units() && places < 40)
    ++places;
  if (in_units(most, places) >= most_units() || in_units(smallest, places) < Integer(1) << 24)
    throw InputError(
        "the sizes are too far apart for the lattice: the box may be some 10^8 smallest discs wide "
        "and high");
  Lattice l{};
  l.places = places;
  l.width =
      static_cast<std::int64_t>(width ? in_units(wide, places) : floor_root(in_units(square, 2 * places), 2));
  l.highest = in_units(high, places).convert_to<double>();
  return l;
}

} // namespace mdm::packing
