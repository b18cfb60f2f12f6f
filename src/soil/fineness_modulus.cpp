#include "soil/fineness_modulus.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {
namespace {

std::vector<Rational> decimals(std::initializer_list<const char *> texts) {
  std::vector<Rational> numbers;
  for (const char *text : texts)
    numbers.push_back(parse_decimal(text));
  return numbers;
}

} // namespace

const std::vector<Rational> &astm_fineness_sieves() {
  static const std::vector<Rational> sieves =
      decimals({"150", "75", "37.5", "19", "9.5", "4.75", "2.36", "1.18", "0.6", "0.3", "0.15"});
  return sieves;
}

const std::vector<Rational> &en_fineness_sieves() {
  static const std::vector<Rational> sieves = decimals({"4", "2", "1", "0.5", "0.25", "0.125"});
  return sieves;
}

Available<Real> fineness_modulus(const GradingCurve &curve, const std::vector<Rational> &sieves) {
  Real sum(0);
  for (const Rational &sieve : sieves) {
    const Available<Real> passing = curve.passing(sieve);
    if (!passing)
      return NotAvailable{to_decimal(sieve) + " mm lies " + passing.why().reason};
    sum = sum + (Real(1) - *passing);
  }
  return sum;
}

} // namespace mdm
