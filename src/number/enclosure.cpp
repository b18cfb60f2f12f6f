#include <mdm/number/enclosure.hpp>

#include <mdm/number/decimal.hpp>

namespace mdm {
namespace {

/// Least number of decimal places with which the decimal r is an integer; nothing if r is no decimal.
std::optional<unsigned> decimal_places(const Rational &r) {
  const std::optional<std::string> text = exact_decimal(r);
  if (!text)
    return std::nullopt;
  const std::size_t point = text->find('.');
  return point == std::string::npos ? 0 : static_cast<unsigned>(text->size() - point - 1);
}

/// Decimal places that give r^(1/degree) `digits` significant digits, or a few more.
unsigned places_for(const Rational &r, unsigned degree, unsigned digits) {
  // y^degree = r has some (bits of r) / degree bits before the point. log10(2) < 0.30103 and > 0.30102; the estimate of
  // the leading digit's place is one too low at most, which gives a digit more than was asked for.
  const long bits = static_cast<long>(bit_length(numerator(r))) - static_cast<long>(bit_length(denominator(r))) - 1;
  const long degree_bits = bits >= 0 ? bits / static_cast<long>(degree) : -((-bits - 1) / static_cast<long>(degree)) - 1;
  const long leading = degree_bits >= 0 ? degree_bits * 30102 / 100000 : -((-degree_bits * 30103 - 1) / 100000) - 1;
  const long wanted = static_cast<long>(digits) - 1 - leading;
  return wanted > 0 ? static_cast<unsigned>(wanted) : 0;
}

} // namespace

Rational Enclosure::lower() const { return ratio(lo, power_of_ten(places)); }
Rational Enclosure::upper() const { return ratio(hi, power_of_ten(places)); }
std::string Enclosure::lower_text() const { return decimal_string(lo, places); }
std::string Enclosure::upper_text() const { return decimal_string(hi, places); }

Enclosure enclose_root(const Rational &r, unsigned degree, unsigned digits) {
  if (const std::optional<Rational> root = exact_root(r, degree)) {
    if (const std::optional<unsigned> places = decimal_places(*root)) {
      const Integer value = numerator(*root) * power_of_ten(*places) / denominator(*root);
      return {value, value, *places};
    }
  }
  const unsigned places = places_for(r, degree, digits);
  const Integer scaled = numerator(r) * power_of_ten(places * degree);
  const Integer lo = floor_root(floor_div(scaled, denominator(r)), degree);
  return {lo, Integer(lo + 1), places};
}

Enclosure enclose_interval(const Rational &lo, const Rational &hi, unsigned digits) {
  const unsigned places = places_for(lo, 1, digits);
  const Rational ten = Rational(power_of_ten(places));
  return {floor(Rational(lo * ten)), ceil(Rational(hi * ten)), places};
}

} // namespace mdm
