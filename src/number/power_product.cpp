// Products of rational powers, about which everything can be decided. The bases are written over integers
// without common factors, found by greatest common divisors of all pairs until none is left: no prime needs
// to be known. Over these the exponents are unique as far as 0 is concerned: a product is 1 only if all of
// them are 0 (powers of different ones share no prime), and a fraction only if each factor is. The search
// for common factors ends, because each division makes the product of all smaller; with more than 1,000
// bases it gives up and says so.

#include "number/power_product.hpp"

#include <cassert>
#include <vector>

namespace mdm {
namespace {

constexpr std::size_t most_bases = 1000;
constexpr std::size_t most_value_bits = 100000;

/// Integers > 1 without common factors, of which all of `numbers` are products.
std::vector<Integer> coprime_base(std::vector<Integer> numbers) {
  std::vector<Integer> base;
  while (!numbers.empty()) {
    const Integer n = std::move(numbers.back());
    numbers.pop_back();
    if (n == 1)
      continue;
    bool coprime = true;
    for (std::size_t i = 0; i < base.size() && coprime; ++i) {
      const Integer common = gcd(n, base[i]);
      if (common == 1)
        continue;
      coprime = false;
      // The product of all numbers falls by the factor `common`: this ends.
      for (const Integer &part : {Integer(n / common), common, Integer(base[i] / common)})
        numbers.push_back(part);
      base[i] = std::move(base.back());
      base.pop_back();
    }
    if (coprime)
      base.push_back(n);
  }
  return base;
}

/// The number of times that the integer p > 1 divides n.
Integer multiplicity(Integer n, const Integer &p) {
  return mpz_remove(n.backend().data(), n.backend().data(), p.backend().data());
}

/// Exponents of the product of `powers` over the coprime integers `base`.
std::vector<Rational> exponents(const std::map<Rational, Rational> &powers,
                                const std::vector<Integer> &base) {
  std::vector<Rational> result(base.size());
  for (std::size_t k = 0; k < base.size(); ++k)
    for (const auto &[b, e] : powers)
      result[k] += e * Rational(multiplicity(numerator(b), base[k]) - multiplicity(denominator(b), base[k]));
  return result;
}

void add_parts(std::vector<Integer> &numbers, const std::map<Rational, Rational> &powers) {
  for (const auto &[b, e] : powers) {
    numbers.push_back(numerator(b));
    numbers.push_back(denominator(b));
  }
}

/// p^exponent, if that is a fraction of acceptable length.
std::optional<Rational> exact_power(const Integer &p, const Rational &exponent) {
  if (exponent == 0)
    return Rational(1);
  const std::size_t bits = bit_length(p);
  const Integer times = abs(numerator(exponent)), degree = denominator(exponent);
  if (degree >= bits || times * bits > degree * most_value_bits) // p < 2^bits has no root of degree bits
    return std::nullopt;
  const std::optional<Rational> root = exact_root(Rational(p), degree.convert_to<unsigned>());
  if (!root)
    return std::nullopt;
  const Rational value = power(*root, times.convert_to<unsigned>());
  return exponent > 0 ? value : Rational(1 / value);
}

} // namespace

PowerProduct::PowerProduct(const Rational &base, const Rational &exponent) {
  assert(base > 0);
  multiply(base, exponent);
}

void PowerProduct::multiply(const Rational &base, const Rational &exponent) {
  if (base == 1 || exponent == 0)
    return;
  Rational &sum = powers_[base];
  sum += exponent;
  if (sum == 0)
    powers_.erase(base);
}

PowerProduct &PowerProduct::operator*=(const PowerProduct &b) {
  for (const auto &[base, exponent] : b.powers_)
    multiply(base, exponent);
  return *this;
}

PowerProduct operator/(const PowerProduct &a, const PowerProduct &b) {
  return a * pow(b, -1);
}

PowerProduct pow(const PowerProduct &a, const Rational &exponent) {
  PowerProduct result;
  for (const auto &[base, e] : a.powers_)
    result.multiply(base, Rational(e * exponent));
  return result;
}

std::optional<Rational> PowerProduct::exact() const {
  if (powers_.size() > most_bases)
    return std::nullopt;
  std::vector<Integer> numbers;
  add_parts(numbers, powers_);
  const std::vector<Integer> base = coprime_base(std::move(numbers));
  const std::vector<Rational> r = exponents(powers_, base);
  Rational value = 1;
  for (std::size_t k = 0; k < base.size(); ++k) {
    const std::optional<Rational> factor = exact_power(base[k], r[k]);
    if (!factor)
      return std::nullopt;
    value *= *factor;
  }
  return value;
}

Ball log(const PowerProduct &a, unsigned bits) {
  Ball sum(0, bits);
  for (const auto &[base, exponent] : a.powers_)
    sum = sum + log(Ball(base, bits)) * Ball(exponent, bits);
  return sum;
}

Real PowerProduct::real() const {
  return Real([a = *this](unsigned bits) { return exp(log(a, bits)); }, [a = *this] { return a.exact(); });
}

std::optional<Rational> exact_log_ratio(const PowerProduct &a, const PowerProduct &b) {
  if (a.powers_.size() + b.powers_.size() > most_bases)
    return std::nullopt;
  std::vector<Integer> numbers;
  add_parts(numbers, a.powers_);
  add_parts(numbers, b.powers_);
  const std::vector<Integer> base = coprime_base(std::move(numbers));
  const std::vector<Rational> u = exponents(a.powers_, base), v = exponents(b.powers_, base);
  std::optional<Rational> ratio;
  for (std::size_t k = 0; k < base.size() && !ratio; ++k)
    if (v[k] != 0)
      ratio = u[k] / v[k];
  for (std::size_t k = 0; k < base.size() && ratio; ++k)
    if (u[k] != *ratio * v[k])
      ratio.reset();
  return ratio;
}

Real log_ratio(const PowerProduct &a, const PowerProduct &b) {
  return Real([a, b](unsigned bits) { return log(a, bits) / log(b, bits); },
              [a, b] { return exact_log_ratio(a, b); });
}

} // namespace mdm
