#include "packing/sphere_sample.hpp"

#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace mdm {

double cut_double(const Rational &r) {
  return mpq_get_d(r.backend().data());
}

void SphereSample::add(const Place &place, const Rational &unit, const Rational &diameter,
                       std::uint32_t group) {
  constexpr double most = 1e60;
  // Cubes of diameters, times lengths and summed, are doubles far from their ends.
  static const Rational largest(power_of_ten(60)), smallest = ratio(1, power_of_ten(60));
  if (diameter > largest || diameter < smallest)
    throw InputError("is of a sphere whose diameter is not from 1e-60 to 1e60: give it in its units");
  assert(centres_.empty() || unit == unit_);
  unit_ = unit;
  const std::uint64_t begin = text_.size();
  std::array<double, 3> centre{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::string decimal(place[axis]);
    std::replace(decimal.begin(), decimal.end(), ',', '.');
    centre[axis] = cut_double(parse_decimal(decimal) * unit);
    if (!(std::abs(centre[axis]) < most))
      throw InputError(in_quotes(place[axis]) + " is beyond 1e60: give a place in its units");
    text_ += decimal + " ";
  }
  begin_.push_back(begin);
  centres_.push_back(centre);
  radii_.push_back(cut_double(diameter / 2));
  diameters_.push_back(diameter);
  groups_.push_back(group);
  for (const double x : centre)
    greatest_ = std::max(greatest_, std::abs(x));
  greatest_ = std::max(greatest_, radii_.back());
}

bool SphereSample::is_of_discs() const {
  constexpr std::size_t least = 4;
  if (size() < least ||
      std::all_of(radii_.begin(), radii_.end(), [this](double r) { return r == radii_.front(); }))
    return false;
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::all_of(centres_.begin(), centres_.end(), [this, axis](const std::array<double, 3> &centre) {
          return centre[axis] == centres_.front()[axis];
        }))
      return true;
  return false;
}

Rational SphereSample::exact_coordinate(std::size_t i, std::size_t axis) const {
  std::size_t begin = begin_[i];
  for (std::size_t skipped = 0; skipped < axis; ++skipped)
    begin = text_.find(' ', begin) + 1;
  return parse_decimal(std::string_view(text_).substr(begin, text_.find(' ', begin) - begin)) * unit_;
}

} // namespace mdm
