#pragma once
/// \file
/// Sizes in 64-bit fixed point.

#include <mdm/number/interval.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace mdm {

/// A size between lo and lo + 1 units of 10^-places, and neither of them.
struct ShortSize {
  std::uint64_t lo;
  unsigned places;
};

/// F^-1(y) = a / (1 - y (1 - (a/b)^p))^(1/p), p = D - 1, of the distribution uniform by volume, in directed
/// integer arithmetic of 64 bits: what it says is proved, and the same on every machine. It decides all but
/// some of thousands of sizes of 15 digits, and none of more than 18. Cost: some 0.1 microseconds.
class QuickSizes {
public:
  /// \param a, b the bounds of the class, 0 < a < b, or what is known of them
  QuickSizes(const Interval &a, const Interval &b, unsigned dimension, unsigned digits);

  /// Decimals of `digits` significant digits around F^-1(y) for every y in [Y, Y + 1] / 2^64, within the
  /// class, open below; nothing where 64 bits do not tell.
  std::optional<ShortSize> at(std::uint64_t y) const;

private:
  __extension__ typedef unsigned __int128 Wide;

  /// Sizes of one number of places.
  struct Decade {
    Wide a_lo, a_hi;           ///< a 10^places 2^(fraction_bits + 64), rounded down and up
    std::uint64_t least, most; ///< what lo may be within the class
    unsigned places;
  };

  unsigned power_, fraction_bits_ = 0;
  std::uint64_t end_ = 0;                   ///< 10^digits
  std::uint64_t drop_lo_ = 0, drop_hi_ = 0; ///< 2^64 (1 - (a/b)^p), rounded down and up
  std::vector<Decade> decades_;             ///< ascending; none: never quick
};

} // namespace mdm
