// Exact arithmetic in the field of one root t = base^(1/m), as polynomials in t below t^m. Because base is
// no p-th power for any prime p that divides m, x^m - base is irreducible, so a number is 0 if and only if
// all coefficients are: equality, which refining never decides, is seen at once. A product is multiplied
// out and t^m replaced by base. Bounds of size classes in geometric steps are such numbers.

#include "number/surd.hpp"

#include <cassert>

namespace mdm {
namespace {

/// The largest divisor e of `degree` for which r^(1/e) is a fraction, and that fraction.
std::pair<unsigned, Rational> largest_root(const Rational &r, unsigned degree) {
  for (unsigned m = 1;; ++m)
    if (degree % m == 0)
      if (const std::optional<Rational> root = exact_root(r, degree / m))
        return {degree / m, *root};
}

} // namespace

void Surd::add(unsigned k, const Rational &r) {
  if (r == 0)
    return;
  Rational &c = c_[k];
  c += r;
  if (c == 0)
    c_.erase(k);
}

Surd Surd::root_power(const Rational &r, unsigned n, unsigned degree) {
  const auto [e, base] = largest_root(r, degree);
  const unsigned m = degree / e;
  Surd result;
  result.degree_ = m;
  if (m > 1)
    result.base_ = base;
  result.add(n % m, mdm::power(base, n / m));
  return result;
}

Surd operator+(const Surd &a, const Surd &b) {
  if (a.degree_ < b.degree_)
    return b + a;
  Surd result = a;
  for (const auto &[k, c] : b.c_)
    result.add(k, c);
  return result;
}

Surd operator-(const Surd &a, const Surd &b) {
  return a + Surd(-1) * b;
}

Surd operator*(const Surd &a, const Surd &b) {
  if (a.degree_ < b.degree_)
    return b * a;
  const unsigned m = a.degree_;
  Surd result;
  result.degree_ = m;
  result.base_ = a.base_;
  for (const auto &[i, c] : a.c_)
    for (const auto &[j, d] : b.c_)
      result.add((i + j) % m, i + j < m ? Rational(c * d) : Rational(c * d * a.base_));
  return result;
}

Surd inverse(const Surd &a) {
  assert(a.c_.size() == 1 && a.c_.begin()->second != 0);
  const auto &[k, c] = *a.c_.begin();
  Surd result;
  result.degree_ = a.degree_;
  result.base_ = a.base_;
  if (k == 0)
    result.add(0, 1 / c);
  else
    result.add(a.degree_ - k, 1 / Rational(c * a.base_));
  return result;
}

std::optional<Rational> Surd::exact() const {
  if (c_.empty())
    return Rational(0);
  if (c_.size() == 1 && c_.begin()->first == 0)
    return c_.begin()->second;
  return std::nullopt;
}

Real Surd::real() const {
  if (const std::optional<Rational> value = exact())
    return Real(*value);
  return Real([*this](unsigned bits) {
    Ball sum(0, bits);
    for (const auto &[k, c] : c_)
      sum = sum + Ball(c, bits) * pow(Ball(base_, bits), ratio(k, degree_));
    return sum;
  });
}

std::optional<PowerProduct> Surd::product() const {
  if (c_.size() != 1 || c_.begin()->second < 0)
    return std::nullopt;
  const auto &[k, c] = *c_.begin();
  return PowerProduct(c) * PowerProduct(base_, ratio(k, degree_));
}

Surd power(const Surd &a, unsigned exponent) {
  Surd result = 1;
  for (Surd square = a; exponent != 0; exponent /= 2, square = square * square)
    if (exponent % 2 != 0)
      result = result * square;
  return result;
}

} // namespace mdm
