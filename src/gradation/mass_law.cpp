#include "number/typed_number.hpp"

#include <mdm/gradation/mass_law.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

[[noreturn]] void refuse_law(std::string_view text) {
  throw InputError(fmt::format("{} is no mass law: write 'sphere', or 'power:a/b' with whole a and b "
                               "from 1 to {}, for example 'power:2' or 'power:5/2'",
                               in_quotes(text), max_law_exponent));
}

/// The exponent behind `power:`: a/b or a decimal.
std::optional<Rational> parse_exponent(std::string_view text) {
  const std::size_t slash = text.find('/');
  if (slash == std::string_view::npos) {
    try {
      return parse_typed_decimal(text);
    } catch (const InputError &) {
      return std::nullopt;
    }
  }
  const std::optional<Integer> a = parse_typed_natural(text.substr(0, slash));
  const std::optional<Integer> b = parse_typed_natural(text.substr(slash + 1));
  if (!a || !b || *b == 0)
    return std::nullopt;
  return ratio(*a, *b);
}

} // namespace

std::string MassLaw::exponent() const {
  return b == 1 ? std::to_string(a) : std::to_string(a) + "/" + std::to_string(b);
}

MassLaw parse_mass_law(std::string_view text) {
  constexpr std::string_view prefix = "power:";
  if (text == "sphere")
    return {};
  if (!text.starts_with(prefix))
    refuse_law(text);
  const std::optional<Rational> exponent = parse_exponent(text.substr(prefix.size()));
  if (!exponent || *exponent <= 0)
    refuse_law(text);
  const Integer a = numerator(*exponent);
  const Integer b = denominator(*exponent);
  if (a > max_law_exponent || b > max_law_exponent)
    refuse_law(text);
  return {a.convert_to<unsigned>(), b.convert_to<unsigned>()};
}

} // namespace mdm
