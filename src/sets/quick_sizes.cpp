// Sizes uniform by volume in 64-bit fixed point: F^-1(y) with every operation rounded in a known direction,
// once down and once up. If both give the same decimal, that is certain, and it is the answer; else there
// is none and the caller computes it with enclosures. All is in integers, so that it is the same on every
// machine, and several hundred times as fast.

#include "sets/quick_sizes.hpp"

#include "number/words.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

__extension__ typedef unsigned __int128 Wide;

constexpr unsigned most_digits = 18;
constexpr unsigned most_places = 1000;
constexpr std::size_t most_decades = 8;
/// If 1 - y C is nearer to 1 than this many units of 2^-64, roots and roundings could reach 2^64.
constexpr std::uint64_t least_drop = std::uint64_t{1} << 12;

const Rational &two_to_64() {
  static const Rational value(Integer(1) << 64);
  return value;
}

/// For 0 <= n < 2^128.
Wide to_wide(const Integer &n) {
  return Wide{word(n, 1)} << 64 | word(n, 0);
}

/// The largest s with s^2 <= n, for 2^64 <= n < (2^64 - 2^11)^2. The double is a guess, whatever its
/// rounding.
std::uint64_t square_root(Wide n) {
  Wide s = static_cast<std::uint64_t>(std::sqrt(static_cast<double>(n)));
  s = (s + n / s) / 2;
  while (s * s > n)
    --s;
  while ((s + 1) * (s + 1) <= n)
    ++s;
  return static_cast<std::uint64_t>(s);
}

} // namespace

QuickSizes::QuickSizes(const Interval &a, const Interval &b, unsigned dimension, unsigned digits)
    : power_(dimension - 1) {
  const Rational drop_lo = (1 - power(Rational(a.hi / b.lo), power_)) * two_to_64();
  const Rational drop_hi = (1 - power(Rational(a.lo / b.hi), power_)) * two_to_64();
  if (digits > most_digits || drop_lo < 0 || Rational(ceil(drop_hi)) >= two_to_64())
    return;
  drop_lo_ = static_cast<std::uint64_t>(floor(drop_lo));
  drop_hi_ = static_cast<std::uint64_t>(ceil(drop_hi));
  const Integer end = power_of_ten(digits);
  end_ = static_cast<std::uint64_t>(end);
  fraction_bits_ = 63 - static_cast<unsigned>(bit_length(end));
  // The most places with which a has no more digits before the unit than asked for.
  unsigned places = 0;
  if (Rational(a.lo) >= Rational(end))
    return;
  while (places < most_places && Rational(a.lo * Rational(power_of_ten(places + 1))) < Rational(end))
    ++places;
  for (;; --places) {
    const Rational scale(power_of_ten(places));
    const Rational fixed = scale * Rational(Integer(1) << fraction_bits_) * two_to_64();
    const Integer most = floor(Rational(b.lo * scale));
    decades_.push_back({to_wide(floor(Rational(a.lo * fixed))), to_wide(ceil(Rational(a.hi * fixed))),
                        static_cast<std::uint64_t>(std::min(Integer(floor(Rational(a.hi * scale)) + 1), end)),
                        static_cast<std::uint64_t>(std::min(most, end)), places});
    if (places == 0 || most < end || decades_.size() == most_decades)
      break;
  }
}

std::optional<ShortSize> QuickSizes::at(std::uint64_t y) const {
  if (decades_.empty())
    return std::nullopt;
  // y C and 1 - y C =: w, in units of 2^-64
  const std::uint64_t drop_lo = static_cast<std::uint64_t>(Wide{y} * drop_lo_ >> 64);
  const Wide up = (Wide{1} << 64) - 1;
  const std::uint64_t drop_hi = static_cast<std::uint64_t>(((Wide{y} + 1) * drop_hi_ + up) >> 64);
  if (drop_lo < least_drop || drop_hi == 0)
    return std::nullopt;
  std::uint64_t w_lo = 0 - drop_hi, w_hi = 0 - drop_lo; // 2^64 - ...
  if (power_ == 2) {
    w_lo = square_root(Wide{w_lo} << 64);
    w_hi = square_root(Wide{w_hi} << 64) + 1;
  }
  for (const Decade &decade : decades_) {
    const Wide x_lo = decade.a_lo / w_hi, x_hi = decade.a_hi / w_lo + 1;
    const Wide lo = x_lo >> fraction_bits_;
    if (lo >= end_)
      continue;
    const bool decided = lo == x_hi >> fraction_bits_ && lo << fraction_bits_ != x_lo;
    if (!decided || lo < decade.least || lo >= decade.most)
      return std::nullopt;
    return ShortSize{static_cast<std::uint64_t>(lo), decade.places};
  }
  return std::nullopt;
}

} // namespace mdm
