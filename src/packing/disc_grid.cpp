#include "packing/disc_grid.hpp"

#include <cmath>
#include <numeric>

namespace mdm::packing {

DiscGrid::DiscGrid(const Packing &packing) : packing_(&packing), smallest_(INT64_MAX) {
  std::int64_t height = 1;
  for (const PackedDisc &d : packing.discs) {
    smallest_ = std::min(smallest_, d.r);
    height = std::max(height, d.y + 1);
  }
  std::vector<std::vector<std::int32_t>> members;
  for (std::size_t i = 0; i < packing.discs.size(); ++i) {
    const std::size_t level = level_of(packing.discs[i].r);
    members.resize(std::max(members.size(), level + 1));
    members[level].push_back(static_cast<std::int32_t>(i));
  }
  levels_.resize(members.size());
  for (std::size_t n = 0; n < members.size(); ++n)
    fill(n, members[n], height);
}

std::size_t DiscGrid::level_of(std::int64_t r) const {
  std::size_t level = 0;
  for (std::int64_t n = r / smallest_; n > 1; n /= 2)
    ++level;
  return level;
}

std::size_t DiscGrid::cell_of(const Level &level, const PackedDisc &d) const {
  const std::int64_t column = std::min(level.columns - 1, d.x / level.cell);
  return static_cast<std::size_t>(d.y / level.cell * level.columns + column);
}

void DiscGrid::fill(std::size_t n, const std::vector<std::int32_t> &members, std::int64_t height) {
  Level &level = levels_[n];
  for (const std::int32_t i : members)
    level.greatest = std::max(level.greatest, disc(i).r);
  // No more cells than some of the discs' number, however few discs of the level there are.
  const double area = static_cast<double>(packing_->width) * static_cast<double>(height);
  const auto least =
      static_cast<std::int64_t>(std::sqrt(area / (4 * static_cast<double>(members.size()) + 16)));
  level.cell = std::max<std::int64_t>({1, 2 * level.greatest, least});
  level.columns = packing_->width / level.cell + 1;
  level.rows = height / level.cell + 1;
  level.begin.assign(static_cast<std::size_t>(level.columns * level.rows) + 1, 0);
  for (const std::int32_t i : members)
    ++level.begin[cell_of(level, disc(i)) + 1];
  std::partial_sum(level.begin.begin(), level.begin.end(), level.begin.begin());
  std::vector<std::size_t> next = level.begin;
  level.discs.resize(members.size());
  for (const std::int32_t i : members)
    level.discs[next[cell_of(level, disc(i))]++] = i;
}

} // namespace mdm::packing
