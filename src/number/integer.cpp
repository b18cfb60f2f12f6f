#include "number/short_digits.hpp"

#include <mdm/number/decimal.hpp>

#include <vector>

namespace mdm {

Integer floor_div(const Integer &n, const Integer &d) {
  Integer quotient;
  mpz_fdiv_q(quotient.backend().data(), n.backend().data(), d.backend().data());
  return quotient;
}

Integer ceil_div(const Integer &n, const Integer &d) {
  Integer quotient;
  mpz_cdiv_q(quotient.backend().data(), n.backend().data(), d.backend().data());
  return quotient;
}

Integer power(const Integer &base, unsigned exponent) {
  // GMP's general power costs several times a product, and squares and cubes are what spheres need.
  if (exponent == 1)
    return base;
  if (exponent == 2)
    return base * base;
  if (exponent == 3)
    return base * base * base;
  Integer result;
  mpz_pow_ui(result.backend().data(), base.backend().data(), exponent);
  return result;
}

Integer power_of_ten(unsigned exponent) {
  // Copying a short power is several times cheaper than making it.
  static const std::vector<Integer> short_powers = [] {
    std::vector<Integer> powers(1, Integer(1));
    while (powers.size() < 128)
      powers.push_back(powers.back() * 10);
    return powers;
  }();
  return exponent < short_powers.size() ? short_powers[exponent] : power(Integer(10), exponent);
}

Integer floor_root(const Integer &n, unsigned degree) {
  if (degree == 1)
    return n;
  Integer root;
  if (degree == 2)
    mpz_sqrt(root.backend().data(), n.backend().data());
  else
    mpz_root(root.backend().data(), n.backend().data(), degree);
  return root;
}

std::size_t bit_length(const Integer &n) {
  return mpz_sizeinbase(n.backend().data(), 2);
}

std::optional<Integer> parse_natural(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (text.empty() || text.size() > max_decimal_digits || !std::all_of(text.begin(), text.end(), is_digit))
    return std::nullopt;
  Integer n;
  mpz_set_str(n.backend().data(), std::string(text).c_str(), 10);
  return n;
}

std::string to_string(const Integer &n) {
  if (const std::optional<ShortDigits> digits = short_digits(n))
    return std::string(digits->text());
  // mpz_sizeinbase may be one too large; two more for the sign and the terminating zero.
  std::string text(mpz_sizeinbase(n.backend().data(), 10) + 2, '\0');
  mpz_get_str(text.data(), 10, n.backend().data());
  text.resize(text.find('\0'));
  return text;
}

} // namespace mdm
