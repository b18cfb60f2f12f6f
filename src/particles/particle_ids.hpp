#pragma once
/// \file
/// The ids of particles, each of which a file has once.

#include <cstdint>
#include <vector>

namespace mdm {

/// A set of whole numbers: a table of blocks of 64 numbers, a bit each.
/// Memory: of ids that mostly follow each other some 3 bits each; at most 43 bytes each, where every id is in
/// a block of its own.
class ParticleIds {
public:
  /// False if it was there already.
  bool insert(std::uint64_t id);
  void clear();

private:
  struct Block {
    std::uint64_t number = 0;
    std::uint64_t bits = 0; ///< 0 where the place is free
  };

  Block &block(std::uint64_t number);
  void grow();

  std::vector<Block> table_; ///< its size is a power of two, or 0
  std::uint64_t used_ = 0;
};

} // namespace mdm
