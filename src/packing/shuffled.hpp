#pragma once
/// \file
/// A random order.

#include "number/philox.hpp"

#include <utility>
#include <vector>

namespace mdm::packing {

/// Streams of random numbers of a deposit; those of sizes have the numbers of classes.
enum Stream : std::uint64_t { order_stream = std::uint64_t{1} << 63, column_stream };

/// Puts things into a random order (Fisher, Yates).
template <class T>
void shuffle(std::vector<T> &things, std::uint64_t seed) {
  const Philox random(seed);
  for (std::size_t i = things.size(); i > 1; --i)
    std::swap(things[i - 1], things[random_below(i, random(order_stream, i))]);
}

} // namespace mdm::packing
