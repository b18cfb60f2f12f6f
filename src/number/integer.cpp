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

/// The cube root of a short n > 0, guessed in double, brought to about 100 bits by a step of Newton's method
/// and proved in integers; nothing if the guess is wrong. Several times cheaper than GMP's root.
std::optional<Integer> short_cube_root(const Integer &n) {
  long exponent = 0;
  const double mantissa = mpz_get_d_2exp(&exponent, n.backend().data());
  const long thirds = exponent / 3;
  constexpr int bits = 52;
  Integer y = static_cast<std::int64_t>(
      std::ldexp(std::cbrt(std::ldexp(mantissa, static_cast<int>(exponent % 3))), bits));
  Integer square, rest;
  const mpz_ptr root = y.backend().data();
  const mpz_ptr y2 = square.backend().data();
  const mpz_ptr r = rest.backend().data();
  if (thirds <= bits) {
    mpz_tdiv_q_2exp(root, root, static_cast<mp_bitcnt_t>(bits - thirds));
  } else {
    mpz_mul_2exp(root, root, static_cast<mp_bitcnt_t>(thirds - bits));
    mpz_mul(y2, root, root);
    mpz_tdiv_q(r, n.backend().data(), y2);
    mpz_addmul_ui(r, root, 2);
    mpz_tdiv_q_ui(root, r, 3);
  }
  // y^3 <= n < (y + 1)^3 iff 0 <= n - y^3 <= 3 (y^2 + y). The step never ends below the root, but may be one
  // above it.
  for (int attempt = 0; attempt < 2; ++attempt, mpz_sub_ui(root, root, 1)) {
    mpz_mul(y2, root, root);
    mpz_mul(r, y2, root);
    mpz_sub(r, n.backend().data(), r);
    if (mpz_sgn(r) < 0)
      continue;
    mpz_add(y2, y2, root);
    mpz_mul_ui(y2, y2, 3);
    return mpz_cmp(r, y2) <= 0 ? std::optional(std::move(y)) : std::nullopt;
  }
  return std::nullopt;
}

} // namespace

Integer floor_root(const Integer &n, unsigned degree) {
  if (degree == 1)
    return n;
  if (degree == 3 && n > 0 && bit_length(n) < 288)
    if (std::optional<Integer> root = short_cube_root(n))
      return std::move(*root);
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
