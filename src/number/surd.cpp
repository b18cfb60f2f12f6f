#include <mdm/number/surd.hpp>

#include <algorithm>

namespace mdm {
namespace {

bool is_zero(const Rational &r) {
  return r == 0;
}

/// The largest divisor e of `degree` for which r^(1/e) is a fraction, and that fraction.
std::pair<unsigned, Rational> largest_root(const Rational &r, unsigned degree) {
  for (unsigned m = 1;; ++m)
    if (degree % m == 0)
      if (const std::optional<Rational> root = exact_root(r, degree / m))
        return {degree / m, *root};
}

} // namespace

Surd Surd::root_power(const Rational &r, unsigned n, unsigned degree) {
  const auto [e, base] = largest_root(r, degree);
  const unsigned m = degree / e;
  Surd result;
  result.c_.assign(m, 0);
  result.c_[n % m] = mdm::power(base, n / m);
  if (m > 1)
    result.base_ = base;
  return result;
}

Surd operator+(const Surd &a, const Surd &b) {
  if (a.degree() < b.degree())
    return b + a;
  Surd result = a;
  for (std::size_t k = 0; k < b.degree(); ++k)
    result.c_[k] += b.c_[k];
  return result;
}

Surd operator-(const Surd &a, const Surd &b) {
  return a + Surd(-1) * b;
}

Surd operator*(const Surd &a, const Surd &b) {
  if (a.degree() < b.degree())
    return b * a;
  const std::size_t m = a.degree();
  Surd result;
  result.base_ = a.base_;
  result.c_.assign(m, 0);
  for (std::size_t i = 0; i < m; ++i) {
    if (is_zero(a.c_[i]))
      continue;
    for (std::size_t j = 0; j < b.degree(); ++j)
      if (!is_zero(b.c_[j])) {
        const Rational product = a.c_[i] * b.c_[j];
        result.c_[(i + j) % m] += i + j < m ? product : Rational(product * a.base_);
      }
  }
  return result;
}

Surd inverse(const Surd &a) {
  const auto at = std::find_if_not(a.c_.begin(), a.c_.end(), is_zero);
  const auto k = static_cast<std::size_t>(at - a.c_.begin());
  Surd result = a;
  result.c_[k] = 0;
  if (k == 0)
    result.c_[0] = 1 / *at;
  else
    result.c_[a.degree() - k] = 1 / Rational(*at * a.base_);
  return result;
}

std::optional<Rational> Surd::exact() const {
  if (std::all_of(c_.begin() + 1, c_.end(), is_zero))
    return c_[0];
  return std::nullopt;
}

Real Surd::real() const {
  if (const std::optional<Rational> value = exact())
    return Real(*value);
  return Real([*this](unsigned bits) {
    Ball sum(c_[0], bits);
    for (std::size_t k = 1; k < degree(); ++k)
      if (!is_zero(c_[k]))
        sum = sum + Ball(c_[k], bits) * pow(Ball(base_, bits), ratio(k, degree()));
    return sum;
  });
}

std::optional<PowerProduct> Surd::product() const {
  const auto at = std::find_if_not(c_.begin(), c_.end(), is_zero);
  if (at == c_.end() || *at < 0 || !std::all_of(at + 1, c_.end(), is_zero))
    return std::nullopt;
  return PowerProduct(*at) * PowerProduct(base_, ratio(at - c_.begin(), degree()));
}

Surd power(const Surd &a, unsigned exponent) {
  Surd result = 1;
  for (Surd square = a; exponent != 0; exponent /= 2, square = square * square)
    if (exponent % 2 != 0)
      result = result * square;
  return result;
}

} // namespace mdm
