#include "number/typed_number.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace mdm {
namespace {

/// Without the underscores that stand between two digits; others stay, and are refused as what they are.
std::string without_separators(std::string_view text) {
  const auto is_digit = [text](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
  std::string digits;
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] != '_' || i == 0 || !is_digit(i - 1) || !is_digit(i + 1))
      digits += text[i];
  return digits;
}

} // namespace

Rational parse_typed_decimal(std::string_view text) {
  return parse_decimal(without_separators(text));
}

std::optional<Integer> parse_typed_natural(std::string_view text) {
  try {
    const Rational r = parse_typed_decimal(text);
    if (r >= 0 && denominator(r) == 1)
      return Integer(numerator(r));
  } catch (const InputError &) { // it is no number
  }
  return std::nullopt;
}

} // namespace mdm
