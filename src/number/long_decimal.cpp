#include "number/long_decimal.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {

Rational parse_long_decimal(std::string_view text) {
  const std::size_t point = std::min(text.find('.'), text.size());
  const std::string_view fraction = text.substr(std::min(point + 1, text.size()));
  const std::string digits = std::string(text.substr(0, point)).append(fraction);
  if (digits.size() <= max_decimal_digits || digits.find_first_not_of("0123456789") != std::string::npos)
    return parse_decimal(text);
  if (digits.size() > max_long_decimal_digits)
    throw InputError(in_quotes(text) + " has more than 100000 digits: round it");
  Integer n;
  mpz_set_str(n.backend().data(), digits.c_str(), 10);
  return ratio(n, power_of_ten(static_cast<unsigned>(fraction.size())));
}

} // namespace mdm
