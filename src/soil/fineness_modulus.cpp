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

std::string_view name(FinenessModulus modulus) {
  return modulus == FinenessModulus::astm ? "FM" : "FM-EN";
}

std::optional<FinenessModulus> fineness_modulus_named(std::string_view text) {
  for (const FinenessModulus modulus : {FinenessModulus::astm, FinenessModulus::en})
    if (text == name(modulus))
      return modulus;
  return std::nullopt;
}

const std::vector<Rational> &fineness_sieves(FinenessModulus modulus) {
  static const std::vector<Rational> astm =
      decimals({"150", "75", "37.5", "19", "9.5", "4.75", "2.36", "1.18", "0.6", "0.3", "0.15"});
  static const std::vector<Rational> en = decimals({"4", "2", "1", "0.5", "0.25", "0.125"});
  return modulus == FinenessModulus::astm ? astm : en;
}

Available<Real> fineness_modulus(const GradingCurve &curve, FinenessModulus modulus) {
  Real sum(0);
  for (const Rational &sieve : fineness_sieves(modulus)) {
    const Available<Real> passing = curve.passing(sieve);
    if (!passing)
      return NotAvailable{to_decimal(sieve) + " mm lies " + passing.why().reason};
    sum = sum + (Real(1) - *passing);
  }
  return sum;
}

} // namespace mdm
