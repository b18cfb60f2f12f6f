#include "gradation/length.hpp"

#include "gradation/shown.hpp"
#include "number/typed_number.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// The length of the number before the unit: `1e5` has none.
std::size_t number_length(std::string_view text) {
  const std::size_t last = text.find_last_of("0123456789._");
  return last == std::string_view::npos ? 0 : last + 1;
}

} // namespace

Rational Length::in(SizeUnit target) const {
  return unit ? Rational(value * in_mm(*unit) / in_mm(target)) : value;
}

Rational Length::in(const Gradation &g) const {
  if (!unit && g.file_unit() == "inches")
    throw InputError(fmt::format(
        "{0} has no unit, and the sizes of the file are in inches: write {0}in or {0}mm", shown(value)));
  return in(g.unit());
}

Length parse_length(std::string_view text) {
  const std::size_t digits = number_length(text);
  std::string_view unit = text.substr(digits);
  if (digits > 0 && unit.starts_with(' '))
    unit.remove_prefix(1);
  Length length;
  Rational in_its_unit = 1;
  if (digits > 0 && unit == "cm") {
    constexpr int millimetres = 10;
    length.unit = SizeUnit::mm;
    in_its_unit = millimetres;
    text = text.substr(0, digits);
  } else if (digits > 0 && !unit.empty()) {
    length.unit = unit == "\u00b5m" || unit == "\u03bcm" ? SizeUnit::um : parse_size_unit(unit);
    if (!length.unit)
      throw InputError(in_quotes(text) + ": " + in_quotes(unit) +
                       " is no unit that is known: write mm, cm, um, m or in, or the number alone");
    text = text.substr(0, digits);
  }
  length.value = parse_typed_decimal(text) * in_its_unit;
  if (length.value <= 0)
    throw InputError(in_quotes(text) + " is not positive: write a length above 0");
  return length;
}

std::vector<Length> parse_lengths(std::string_view text) {
  std::vector<Length> lengths;
  for (;;) {
    const std::size_t end = text.find('x');
    lengths.push_back(parse_length(trimmed(text.substr(0, end)))); // `5 mm x 10 mm`
    if (end == std::string_view::npos)
      return lengths;
    text.remove_prefix(end + 1);
  }
}

} // namespace mdm
