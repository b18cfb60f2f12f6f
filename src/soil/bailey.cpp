#include "soil/bailey.hpp"

namespace mdm {
namespace {

std::optional<Rational> quotient(const Rational &a, const Rational &b) {
  return b == 0 ? std::nullopt : std::optional<Rational>(a / b);
}

} // namespace

const std::array<BaileySieves, 6> &bailey_sieves() {
  static const std::array<BaileySieves, 6> sieves = {
      {{ratio(75, 2), 19, ratio(19, 2), ratio(59, 25), ratio(3, 5)},
       {25, ratio(25, 2), ratio(19, 4), ratio(59, 50), ratio(3, 10)},
       {19, ratio(19, 2), ratio(19, 4), ratio(59, 50), ratio(3, 10)},
       {ratio(25, 2), ratio(25, 4), ratio(59, 25), ratio(3, 5), ratio(3, 20)},
       {ratio(19, 2), ratio(19, 4), ratio(59, 25), ratio(3, 5), ratio(3, 20)},
       {ratio(19, 4), ratio(59, 25), ratio(59, 50), ratio(3, 10), ratio(3, 40)}}};
  return sieves;
}

BaileyRatios bailey_ratios(const std::array<Rational, 4> &passing) {
  const auto &[half, primary, secondary, tertiary] = passing;
  return {quotient(half - primary, 100 - half), quotient(secondary, primary), quotient(tertiary, secondary)};
}

} // namespace mdm
