#pragma once
/// \file
/// A part of a suite.

#include <cstdint>
#include <string>

namespace mdm {

/// The shard `number` of `count`: of the lines of a suite that hold something, counted from 1, those whose
/// number leaves the same remainder by `count` as `number`. So a suite needs no first pass to be divided,
/// and answers are joined by taking turns.
struct Shard {
  std::uint64_t number = 1, count = 1;

  /// \param line from 1 on, blank ones not counted
  bool has(std::uint64_t line) const { return line % count == number % count; }
};

/// `I/N`. \throws InputError if it is not that, with 1 <= I <= N <= 10^9
Shard parse_shard(const std::string &text);

} // namespace mdm
