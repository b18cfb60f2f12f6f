#pragma once
/// \file
/// What a product of doubles loses when it is rounded.

#include <cmath>

namespace mdm {

/// a b - product, exactly, where the product is a b as a double rounds it, and all are between 2^-220 and
/// 2^100 in size, or 0 (Lemma 18).
inline double product_error(double a, double b, double product) {
#ifdef _WIN32
  // The fma of mingw-w64 errs by up to 2^-77 of the product. Dekker's: halves of 26 bits have exact products.
  constexpr double halving = 0x1p27 + 1;
  const double a_far = halving * a, b_far = halving * b;
  const double a_high = a_far - (a_far - a), b_high = b_far - (b_far - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
#else
  return std::fma(a, b, -product);
#endif
}

} // namespace mdm
