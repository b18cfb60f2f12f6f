#include "number/nearest_double.hpp"

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>

namespace mdm {
namespace {

#ifdef __cpp_lib_to_chars
template <class Number>
std::optional<Number> nearest(std::string_view decimal) {
  Number value = 0;
  const std::from_chars_result read = std::from_chars(decimal.data(), decimal.data() + decimal.size(), value);
  if (read.ec != std::errc() || read.ptr != decimal.data() + decimal.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}
#else
// The standard library has from_chars for integers alone.
double converted(const char *text, char **end, double) {
  return std::strtod(text, end);
}

float converted(const char *text, char **end, float) {
  return std::strtof(text, end);
}

/// strtod takes more than decimals: spaces, hexadecimals, words, a plus sign.
template <class Number>
std::optional<Number> nearest(std::string_view decimal) {
  const std::string text(decimal);
  if (text.empty() || text.front() == '+' || text.find_first_not_of("0123456789.eE+-") != std::string::npos)
    return std::nullopt;
  char *end = nullptr;
  const Number value = converted(text.c_str(), &end, Number());
  const bool is_zero =
      text.substr(0, text.find_first_of("eE")).find_first_of("123456789") == std::string::npos;
  if (end != text.c_str() + text.size() || !std::isfinite(value) || (value == 0 && !is_zero))
    return std::nullopt;
  return value;
}
#endif

} // namespace

std::optional<double> nearest_double(std::string_view decimal) {
  return nearest<double>(decimal);
}

std::optional<float> nearest_float(std::string_view decimal) {
  return nearest<float>(decimal);
}

} // namespace mdm
