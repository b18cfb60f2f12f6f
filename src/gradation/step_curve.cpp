#include "gradation/step_curve.hpp"

#include "number/decimal_exponent.hpp"

namespace mdm {

void add_step(Gradation::Data &data, const Rational &least, const Rational &most, const Rational &mass) {
  static const Rational part_below = 1 - ten_to(-12);
  if (const Rational below = least * part_below; below > data.sizes.back()) {
    data.sizes.push_back(below);
    data.masses.emplace_back(0);
  }
  data.sizes.push_back(most);
  data.masses.push_back(mass);
}

} // namespace mdm
