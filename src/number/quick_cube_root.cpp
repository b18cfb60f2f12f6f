// Cube roots in pairs of doubles (Lemma 18, which has the proof of all bounds here). A quotient is cut to
// 106 bits, its root found in double precision, and corrected once by Newton's step with the remainder
// computed exactly: the pair is then right to 2^-97 of itself. If the product with 10^places is
// farther from every integer than that error, the integer below it is certain, and is the answer; else
// there is none, and the caller goes to integers.
//
// may_be_cube takes the remainders by eight numbers: of 3,000 fractions that are no cubes all but one are
// told at once.

#include "number/quick_cube_root.hpp"

#include "number/product_error.hpp"
#include "number/words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace mdm {
namespace {

__extension__ typedef unsigned __int128 Wide;

/// (high + low) 2^exponent with high in [1/2, 1) and low in [0, 2^-53): a number cut after its first 106
/// bits.
struct Leading {
  double high, low;
  long exponent;
};

Leading leading(const Integer &n) {
  const long bits = static_cast<long>(bit_length(n));
  const long last = (bits - 1) / 64;
  const int shift = static_cast<int>(64 * (last + 1) - bits);
  Wide top = static_cast<Wide>(word(n, last)) << 64 | word(n, last - 1);
  if (shift > 0)
    top = top << shift | word(n, last - 2) >> (64 - shift);
  constexpr std::uint64_t lower_half = (std::uint64_t{1} << 53) - 1;
  return {static_cast<double>(static_cast<std::uint64_t>(top >> 75)) * 0x1p-53,
          static_cast<double>(static_cast<std::uint64_t>(top >> 22) & lower_half) * 0x1p-106, bits};
}

/// 10^0, 10^1, ...
const std::vector<Leading> &powers_of_ten() {
  static const std::vector<Leading> powers = [] {
    std::vector<Leading> made;
    for (unsigned exponent = 0; exponent < 64; ++exponent)
      made.push_back(leading(power_of_ten(exponent)));
    return made;
  }();
  return powers;
}

/// Bit r of the mask is set if r is a cube modulo p.
struct CubesModulo {
  unsigned p;
  std::uint64_t mask = 0;

  explicit constexpr CubesModulo(unsigned modulus) : p(modulus) {
    for (unsigned y = 0; y < p; ++y)
      mask |= std::uint64_t{1} << (y * y * y % p);
  }
};

/// One division for all four, whose product is below 2^32.
bool may_be_cube_modulo(const std::array<CubesModulo, 4> &cubes, const Integer &n, const Integer &d) {
  unsigned long product = 1;
  for (const CubesModulo &modulo : cubes)
    product *= modulo.p;
  const std::uint64_t n_rest = mpz_tdiv_ui(n.backend().data(), product);
  const std::uint64_t d_rest = mpz_tdiv_ui(d.backend().data(), product);
  return std::all_of(cubes.begin(), cubes.end(), [&](const CubesModulo &modulo) {
    const std::uint64_t y = d_rest % modulo.p;
    return (modulo.mask >> (n_rest % modulo.p * y * y % modulo.p) & 1) != 0;
  });
}

} // namespace

std::optional<Integer> quick_cube_root(const Integer &n, const Integer &d, unsigned places) {
  if (places >= powers_of_ten().size())
    return std::nullopt;
  // n/d = (a/b) 2^(3 thirds), a/b in (1/2, 8).
  Leading a = leading(n);
  const Leading b = leading(d);
  const Leading &ten = powers_of_ten()[places];
  const long twos = ((a.exponent - b.exponent) % 3 + 3) % 3;
  const long thirds = (a.exponent - b.exponent - twos) / 3;
  const long exponent = thirds + ten.exponent;
  constexpr long widest_exponent = 96;
  if (exponent < 0 || exponent > widest_exponent)
    return std::nullopt;
  a.high *= static_cast<double>(1L << twos);
  a.low *= static_cast<double>(1L << twos);

  // A guess x, and a step of Newton's method with a - x^3 b to twice a double's precision.
  const double x = std::cbrt(a.high / b.high);
  const double square = x * x;
  const double square_low = product_error(x, x, square);
  const double cube = square * x;
  const double cube_low = product_error(square, x, cube) + square_low * x;
  const double product = cube * b.high;
  const double product_low = product_error(cube, b.high, product) + (cube * b.low + cube_low * b.high);
  const double step = ((a.high - product) + (a.low - product_low)) / (3 * square * b.high);
  if (!(std::abs(step) <= 0x1p-50 * x))
    return std::nullopt;

  const double high = x * ten.high;
  const double low = product_error(x, ten.high, high) + (x * ten.low + step * ten.high);
  const double root = std::ldexp(high, static_cast<int>(exponent));
  const double whole = std::floor(root);
  const double rest = (root - whole) + std::ldexp(low, static_cast<int>(exponent));
  const double floor = std::floor(rest);
  const double slack = root * 0x1p-95 + 0x1p-49;
  if (!(rest - floor > slack && floor + 1 - rest > slack))
    return std::nullopt;
  Integer result;
  mpz_set_d(result.backend().data(), whole);
  return result + static_cast<std::int64_t>(floor);
}

bool may_be_cube(const Integer &n, const Integer &d) {
  // n/d = y^3 makes n d^2 = (y d)^3 the cube of an integer, and thus one modulo each of these.
  static constexpr std::array<CubesModulo, 4> first = {CubesModulo(7), CubesModulo(9), CubesModulo(13),
                                                       CubesModulo(19)};
  static constexpr std::array<CubesModulo, 4> second = {CubesModulo(31), CubesModulo(37), CubesModulo(43),
                                                        CubesModulo(61)};
  return may_be_cube_modulo(first, n, d) && may_be_cube_modulo(second, n, d);
}

} // namespace mdm
