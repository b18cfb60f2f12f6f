#include "particles/particle_ids.hpp"

namespace mdm {
namespace {

constexpr std::size_t first_size = 64;

/// The last steps of SplitMix64 (Steele, Lea, Flood 2014): close numbers are spread over all of the table.
std::uint64_t spread(std::uint64_t n) {
  n = (n ^ (n >> 30U)) * 0xbf58476d1ce4e5b9;
  n = (n ^ (n >> 27U)) * 0x94d049bb133111eb;
  return n ^ (n >> 31U);
}

} // namespace

bool ParticleIds::insert(std::uint64_t id) {
  constexpr unsigned bits_of_block = 6;
  if (4 * (used_ + 1) > 3 * table_.size())
    grow();
  const std::uint64_t number = id >> bits_of_block, bit = std::uint64_t{1} << (id & 63U);
  Block &found = block(number);
  if ((found.bits & bit) != 0)
    return false;
  if (found.bits == 0) {
    found.number = number;
    ++used_;
  }
  found.bits |= bit;
  return true;
}

void ParticleIds::clear() {
  table_.clear();
  used_ = 0;
}

ParticleIds::Block &ParticleIds::block(std::uint64_t number) {
  const std::size_t last = table_.size() - 1;
  std::size_t at = spread(number) & last;
  while (table_[at].bits != 0 && table_[at].number != number)
    at = (at + 1) & last;
  return table_[at];
}

void ParticleIds::grow() {
  std::vector<Block> old(table_.empty() ? first_size : 2 * table_.size());
  old.swap(table_);
  for (const Block &b : old)
    if (b.bits != 0)
      block(b.number) = b;
}

} // namespace mdm
