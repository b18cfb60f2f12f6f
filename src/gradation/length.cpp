#include "gradation/length.hpp"

#include "number/typed_number.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 4> length_unit_names = {"mm", "um", "m", "in"};

/// The length of the number before the unit: `1e5` has none.
std::size_t number_length(std::string_view text) {
  const std::size_t last = text.find_last_of("0123456789._");
  return last == std::string_view::npos ? 0 : last + 1;
}

} // namespace

std::string_view name(LengthUnit unit) {
  return length_unit_names.at(static_cast<std::size_t>(unit));
}

std::optional<LengthUnit> parse_length_unit(std::string_view name) {
  const auto *const found = std::find(length_unit_names.begin(), length_unit_names.end(), name);
  if (found == length_unit_names.end())
    return std::nullopt;
  return static_cast<LengthUnit>(found - length_unit_names.begin());
}

LengthUnit length_unit(SizeUnit unit) {
  return parse_length_unit(name(unit)).value();
}

Rational in_mm(LengthUnit unit) {
  switch (unit) {
  case LengthUnit::um:
    return ratio(1, 1000);
  case LengthUnit::m:
    return 1000;
  case LengthUnit::in:
    return ratio(254, 10);
  case LengthUnit::mm:
    break;
  }
  return 1;
}

Rational Length::in(SizeUnit target) const {
  return unit ? Rational(value * in_mm(*unit) / in_mm(target)) : value;
}

Length parse_length(std::string_view text) {
  const std::size_t digits = number_length(text);
  std::string_view unit = text.substr(digits);
  if (digits > 0 && unit.starts_with(' '))
    unit.remove_prefix(1);
  Length length;
  if (digits > 0 && !unit.empty()) {
    length.unit = unit == "\u00b5m" || unit == "\u03bcm" ? LengthUnit::um : parse_length_unit(unit);
    if (!length.unit)
      throw InputError(in_quotes(text) + ": " + in_quotes(unit) +
                       " is no unit that is known: write mm, um, m or in, or the number alone");
    text = text.substr(0, digits);
  }
  length.value = parse_typed_decimal(text);
  if (length.value <= 0)
    throw InputError(in_quotes(text) + " is not positive: write a length above 0");
  return length;
}

std::vector<Length> parse_lengths(std::string_view text) {
  std::vector<Length> lengths;
  for (;;) {
    const std::size_t end = text.find('x');
    lengths.push_back(parse_length(text.substr(0, end)));
    if (end == std::string_view::npos)
      return lengths;
    text.remove_prefix(end + 1);
  }
}

} // namespace mdm
