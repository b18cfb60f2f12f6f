#pragma once
/// \file
/// Random numbers that are the same on every machine.

#include <array>
#include <cstdint>

namespace mdm {

/// Philox 4x32-10 (Salmon, Moraes, Dror, Shaw 2011): a random function of a counter. It has no state: every
/// number of a stream can be had by itself, in any order.
class Philox {
public:
  using Block = std::array<std::uint32_t, 4>;
  using Key = std::array<std::uint32_t, 2>;

  explicit Philox(Key key) : key_(key) {}
  explicit Philox(std::uint64_t seed)
      : key_{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)} {}

  /// 128 random bits.
  Block operator()(Block counter) const {
    constexpr int rounds = 10;
    Key key = key_;
    for (int i = 0; i < rounds; ++i) {
      const std::uint64_t p = std::uint64_t{0xD2511F53} * counter[0];
      const std::uint64_t q = std::uint64_t{0xCD9E8D57} * counter[2];
      counter = {high(q) ^ counter[1] ^ key[0], low(q), high(p) ^ counter[3] ^ key[1], low(p)};
      key = {key[0] + 0x9E3779B9U, key[1] + 0xBB67AE85U};
    }
    return counter;
  }

  /// 64 random bits: the number `index` of the stream `stream`.
  std::uint64_t operator()(std::uint64_t stream, std::uint64_t index) const {
    const Block b = (*this)(Block{low(index), high(index), low(stream), high(stream)});
    return std::uint64_t{b[1]} << 32 | b[0];
  }

private:
  static constexpr std::uint32_t low(std::uint64_t n) { return static_cast<std::uint32_t>(n); }
  static constexpr std::uint32_t high(std::uint64_t n) { return static_cast<std::uint32_t>(n >> 32); }

  Key key_;
};

/// A number from 0 to n - 1, for 64 random bits: floor(bits n / 2^64).
inline std::uint64_t random_below(std::uint64_t n, std::uint64_t bits) {
  __extension__ typedef unsigned __int128 Product;
  return static_cast<std::uint64_t>((Product{bits} * n) >> 64);
}

} // namespace mdm
