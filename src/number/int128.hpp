#pragma once
/// \file
/// The fast tier of exact arithmetic: 128-bit integers that notice when they overflow.

#include <mdm/number/integer.hpp>

#ifndef __SIZEOF_INT128__
#error "exactmdm needs 128-bit integers: g++ and clang have them on 64-bit machines and for WebAssembly"
#endif

namespace mdm {

/// Thrown by Int128 instead of a wrong result; the computation is then repeated with Integer.
struct Int128Overflow {};

/// A checked 128-bit integer: every operation is exact or throws Int128Overflow.
class Int128 {
public:
  Int128() = default;
  Int128(int value) : value_(value) {}
  Int128(std::int64_t value) : value_(value) {}
  Int128(bool) = delete;
  Int128(double) = delete;
  /// \throws Int128Overflow if n does not fit
  explicit Int128(const Integer &n);

  Integer to_integer() const;
  /// The nearest double.
  double to_double() const { return static_cast<double>(value_); }

  friend Int128 operator+(Int128 a, Int128 b) {
    if (__builtin_add_overflow(a.value_, b.value_, &a.value_))
      throw Int128Overflow{};
    return a;
  }
  friend Int128 operator*(Int128 a, Int128 b) {
    if (__builtin_mul_overflow(a.value_, b.value_, &a.value_))
      throw Int128Overflow{};
    return a;
  }
  friend bool operator==(Int128 a, Int128 b) { return a.value_ == b.value_; }
  friend bool operator<(Int128 a, Int128 b) { return a.value_ < b.value_; }
  friend bool operator>(Int128 a, Int128 b) { return b < a; }
  friend bool operator<=(Int128 a, Int128 b) { return !(b < a); }
  friend bool operator>=(Int128 a, Int128 b) { return !(a < b); }

  /// Largest integer <= n / d, for n >= 0 and d > 0: there C++ division rounds down.
  friend Int128 floor_div(Int128 n, Int128 d) {
    n.value_ /= d.value_;
    return n;
  }
  friend Int128 power(Int128 base, unsigned exponent) {
    Int128 result = exponent == 0 ? Int128(1) : base;
    for (unsigned i = 1; i < exponent; ++i)
      result = result * base;
    return result;
  }
  /// Largest integer y with y^degree <= n, for n >= 0.
  friend Int128 floor_root(Int128 n, unsigned degree) {
    return degree == 1 ? n : Int128(floor_root(n.to_integer(), degree));
  }

private:
  __extension__ typedef __int128 Value;
  Value value_ = 0;
};

} // namespace mdm
