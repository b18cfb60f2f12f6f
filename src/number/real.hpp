#pragma once
/// \file
/// Real numbers to any precision.

#include "number/ball.hpp"

#include <mdm/number/enclosure.hpp>

#include <functional>
#include <memory>

namespace mdm {

/// The precision at which refining ends: some 1,200 decimal digits.
inline constexpr unsigned most_bits = 4096;

/// A real number as a computation that encloses it to any precision, with its exact value where that is
/// known. Refining alone never decides whether a number is 6: hence the exact value.
class Real {
public:
  using Enclose = std::function<Ball(unsigned bits)>;
  using Exact = std::function<std::optional<Rational>()>;

  Real(Rational value);
  Real(int value) : Real(Rational(value)) {}
  /// `exact` answers the value if it is a fraction and that can be told. It is asked only where refining does
  /// not decide, so it may take its time.
  explicit Real(Enclose enclose, Exact exact = nullptr);

  Ball ball(unsigned bits) const { return node_->enclose(bits); }
  std::optional<Rational> exact() const { return node_->exact ? node_->exact() : std::nullopt; }
  /// The value of a real that was made from a fraction, or from sums and products of such.
  const std::optional<Rational> &fraction() const { return node_->fraction; }

  friend Real operator+(const Real &a, const Real &b);
  friend Real operator-(const Real &a, const Real &b);
  friend Real operator*(const Real &a, const Real &b);
  /// \pre b != 0
  friend Real operator/(const Real &a, const Real &b);
  /// \pre y > 0
  friend Real pow(const Real &y, const Rational &exponent);

private:
  struct Node {
    std::optional<Rational> fraction;
    Enclose enclose;
    Exact exact;
  };

  std::shared_ptr<const Node> node_; // shared: computations are built from computations
};

/// Decided by refining; undecided if most_bits do not separate the two and their exact values are not known.
Order compare(const Real &a, const Real &b);

/// Certain bounds of an integer: lo = hi where it is known.
struct IntegerBounds {
  Integer lo, hi;

  bool is_point() const { return lo == hi; }
};

/// The largest integer <= y, decided by refining. `is_exactly(k)` answers true only if y = k; it is asked
/// once, where refining has left two integers.
IntegerBounds floor_of(const Real &y, const std::function<bool(const Integer &k)> &is_exactly = nullptr);

/// Decimals around y of `digits` >= 1 significant digits (more if y has more before its point): one unit of
/// the last digit apart, two where most_bits do not tell on which side of a decimal y lies; lo = hi where y
/// is known to be a decimal.
Enclosure enclose(const Real &y, unsigned digits);

/// y rounded to the nearest decimal of `digits` >= 1 significant digits (more where it has more, up to 15,
/// before its point), halves away from 0: all digits are certain, and there are fewer of them where most_bits
/// do not tell. Zeros at the end are left out where y is that decimal exactly. With an exponent below 1e-6
/// and from 1e15 on.
std::string rounded(const Real &y, unsigned digits);

} // namespace mdm
