#pragma once
/// \file
/// Random whole numbers, one after the other.

#include "number/philox.hpp"

#include <mdm/number/integer.hpp>

#include <cassert>

namespace mdm {

/// The numbers of one stream of Philox in their order, and choices made of them in integers alone. A choice
/// of one takes no number.
class RandomStream {
public:
  RandomStream(std::uint64_t seed, std::uint64_t stream) : random_(seed), stream_(stream) {}

  /// The next 64 bits.
  std::uint64_t next() { return random_(stream_, index_++); }

  /// One of 0, ..., n - 1: floor(r n / 2^64) of the next number r. \pre n >= 1
  std::uint32_t below(std::uint32_t n) {
    assert(n >= 1);
    return n == 1 ? 0 : static_cast<std::uint32_t>(random_below(n, next()));
  }

  /// The same for n of any length: floor(r n / 2^b), where r has the bits of so many numbers, the first on
  /// top, that b is at least 64 more than the bits of n.
  Integer below(const Integer &n) {
    assert(n >= 1);
    if (n == 1)
      return 0;
    const std::size_t numbers = (bit_length(n) + 63) / 64 + 1;
    Integer r = 0;
    for (std::size_t i = 0; i < numbers; ++i)
      r = (r << 64) + next();
    return Integer(r * n) >> static_cast<unsigned>(64 * numbers);
  }

private:
  Philox random_;
  std::uint64_t stream_;
  std::uint64_t index_ = 0;
};

} // namespace mdm
