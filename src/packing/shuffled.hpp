#pragma once
/// \file
/// A random order.

#include "number/philox.hpp"

#include <utility>
#include <vector>

namespace mdm::packing {

/// Streams of random numbers of a deposit; those of sizes have the numbers of classes.
enum Stream : std::uint64_t { order_stream = std::uint64_t{1} << 63, column_stream };

/// A number from 0 to n - 1, for 64 random bits.
inline std::uint64_t below(std::uint64_t n, std::uint64_t bits) {
  __extension__ typedef unsigned __int128 Product;
  return static_cast<std::uint64_t>((Product{bits} * n) >> 64);
}

/// Puts things into a random order (Fisher, Yates).
template <class T>
void shuffle(std::vector<T> &things, std::uint64_t seed) {
  const Philox random(seed);
  for (std::size_t i = things.size(); i > 1; --i)
    std::swap(things[i - 1], things[below(i, random(order_stream, i))]);
}

} // namespace mdm::packing
