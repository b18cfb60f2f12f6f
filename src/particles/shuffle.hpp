#pragma once
/// \file
/// Numbers that look random and are a function of what they are asked for: the same on every machine.

#include <cstdint>

namespace mdm {

/// The finalizer of SplitMix64: a bijection that mixes all bits.
inline std::uint64_t mixed(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

/// The place of i < n in a permutation of 0, ..., n - 1 that the key chooses: a Feistel network of four
/// rounds on the least 4^k >= n, repeated until it is below n, which takes four rounds of it on average at
/// most.
inline std::uint64_t shuffled(std::uint64_t i, std::uint64_t n, std::uint64_t key) {
  unsigned half = 1;
  while (half < 32 && (std::uint64_t{1} << (2 * half)) < n)
    ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = i >> half, right = i & mask;
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t next = left ^ (mixed(key ^ mixed((round << 32) ^ right)) & mask);
      left = right;
      right = next;
    }
    i = (left << half) | right;
  } while (i >= n);
  return i;
}

} // namespace mdm
