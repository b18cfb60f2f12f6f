#pragma once
/// \file
/// All discs of a packing by their places.

#include "packing/packing.hpp"

#include <algorithm>

namespace mdm::packing {

/// Discs in square cells, one grid for radii within a factor of 2.
class DiscGrid {
public:
  explicit DiscGrid(const Packing &packing);

  /// Calls take(j, dx, dy) for each disc j that may be within `reach` of the disc i, once for every pair of
  /// discs or of their images, and from either of the two; (dx, dy) is from the centre of i to that of j.
  template <class Take>
  void each_pair_of(std::int32_t i, std::int64_t reach, const Take &take) const;

private:
  struct Level {
    std::int64_t greatest = 0; ///< radius
    std::int64_t cell = 1;     ///< side of a cell, but for the last of a row
    std::int64_t columns = 1, rows = 1;
    std::vector<std::size_t> begin; ///< of each cell's discs
    std::vector<std::int32_t> discs;
  };

  const PackedDisc &disc(std::int32_t i) const { return packing_->discs[static_cast<std::size_t>(i)]; }
  std::size_t level_of(std::int64_t r) const;
  std::size_t cell_of(const Level &level, const PackedDisc &d) const;
  void fill(std::size_t level, const std::vector<std::int32_t> &members, std::int64_t height);

  const Packing *packing_;
  std::int64_t smallest_;
  std::vector<Level> levels_;
};

template <class Take>
void DiscGrid::each_pair_of(std::int32_t i, std::int64_t reach, const Take &take) const {
  const PackedDisc &d = disc(i);
  for (std::size_t n = level_of(d.r); n < levels_.size(); ++n) {
    const Level &level = levels_[n];
    const std::int64_t far = d.r + level.greatest + reach;
    const std::int64_t low = std::max<std::int64_t>(0, (d.y - far) / level.cell),
                       high = std::min(level.rows - 1, (d.y + far) / level.cell);
    for (int image = packing_->periodic ? -1 : 0; image <= (packing_->periodic ? 1 : 0); ++image) {
      const std::int64_t x = d.x - image * packing_->width;
      if (x + far < 0 || x - far > packing_->width)
        continue;
      const std::int64_t left = std::max<std::int64_t>(0, (x - far) / level.cell),
                         right = std::min(level.columns - 1, (x + far) / level.cell);
      for (std::int64_t row = low; row <= high; ++row)
        for (std::size_t k = level.begin[static_cast<std::size_t>(row * level.columns + left)];
             k < level.begin[static_cast<std::size_t>(row * level.columns + right + 1)]; ++k) {
          const std::int32_t j = level.discs[k];
          if (n > level_of(d.r) || j < i)
            take(j, disc(j).x - x, disc(j).y - d.y);
        }
    }
  }
}

} // namespace mdm::packing
