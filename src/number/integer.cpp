#include <mdm/number/decimal.hpp>
#include <mdm/number/integer.hpp>

#include <algorithm>
#include <cmath>
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

namespace {

/// A number near n^(1/degree), for n > 0: a root in double, brought to about 100 bits by a step of Newton's
/// method.
Integer near_root(const Integer &n, unsigned degree) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, n.backend().data());
  const long shift = exponent / static_cast<long>(degree);
  const double root =
      std::pow(std::ldexp(mantissa, static_cast<int>(exponent - shift * static_cast<long>(degree))),
               1.0 / static_cast<double>(degree));
  constexpr int bits = 52;
  Integer y = static_cast<std::int64_t>(std::ldexp(root, bits));
  if (shift <= bits)
    return y >> static_cast<unsigned>(bits - shift);
  y <<= static_cast<unsigned>(shift - bits);
  Integer z = power(y, degree - 1);
  mpz_tdiv_q(z.backend().data(), n.backend().data(), z.backend().data());
  mpz_addmul_ui(z.backend().data(), y.backend().data(), degree - 1);
  mpz_tdiv_q_ui(z.backend().data(), z.backend().data(), degree);
  return z;
}

/// True if y^degree <= n < (y + 1)^degree.
bool is_floor_root(const Integer &y, const Integer &n, unsigned degree) {
  return power(y, degree) <= n && n < power(Integer(y + 1), degree);
}

} // namespace

Integer floor_root(const Integer &n, unsigned degree) {
  if (degree == 1)
    return n;
  // A short root is guessed in floating point and proved in integers, several times cheaper than GMP's root.
  if (const std::size_t bits = bit_length(n); degree <= 3 && bits > 8 && bits < 96 * degree) {
    const Integer y = near_root(n, degree);
    for (const int off : {0, -1, 1})
      if (is_floor_root(Integer(y + off), n, degree))
        return y + off;
  }
  Integer root;
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
  // mpz_sizeinbase may be one too large; two more for the sign and the terminating zero.
  std::string text(mpz_sizeinbase(n.backend().data(), 10) + 2, '\0');
  mpz_get_str(text.data(), 10, n.backend().data());
  text.resize(text.find('\0'));
  return text;
}

} // namespace mdm
