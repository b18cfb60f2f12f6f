#pragma once
/// \file
/// The spheres of a deposit by their places.

#include "packing/sphere_deposit.hpp"
#include "packing/vector3.hpp"

#include <algorithm>
#include <limits>

namespace mdm::packing {

/// Spheres in cells, one grid for radii within a factor of 2. Coordinates and radii are whole numbers in
/// doubles.
class SphereGrid {
public:
  /// \param radii of all spheres, also of those that are not laid yet
  SphereGrid(std::vector<double> radii, const SphereSpace &space);

  double radius(std::int32_t id) const { return radii_[static_cast<std::size_t>(id)]; }
  void add(std::int32_t id, const Vector3 &centre);

  /// Calls take(id, centre) for the spheres at less than `near` from a sphere of radius q around p, and some
  /// beyond; for every image where they are repeated. \pre none overlaps that sphere by more than `slack`
  template <class Take>
  void each_near(const Vector3 &p, double q, double near, double slack, const Take &take) const;

  /// Calls take(id, centre) for all spheres whose upper side a sphere of radius q at height z or below may
  /// touch that falls in the column (x, y). `take` gives the height from which on what it touches is of
  /// interest.
  template <class Take>
  void each_below(const Vector3 &p, double q, const Take &take) const;

private:
  static constexpr std::int32_t none = -1;

  /// The cells of spheres of about one size.
  struct Level {
    double least = std::numeric_limits<double>::infinity(), greatest = 0; ///< radii
    std::array<double, 3> cell{};                                         ///< sides
    std::array<std::int64_t, 3> n{};                                      ///< cells; rows as far as needed
    std::vector<std::int32_t> first;                                      ///< sphere of each cell, or none
  };

  /// A column of cells, and how far off it is.
  struct Column {
    std::int64_t index;         ///< of its cell in a row
    double shift_x, shift_y;    ///< of the image
    double nearest2, farthest2; ///< squares of horizontal distances
  };

  std::size_t level_of(double radius) const;
  void make_cells(Level &level, double number) const;
  std::int64_t cell_of(const Level &level, std::size_t axis, double x) const;
  template <class Take>
  void each_column(const Level &level, const Vector3 &p, double reach, const Take &take) const;
  template <class Take>
  void each_in(const Level &level, const Column &column, std::int64_t row, const Take &take) const;

  SphereSpace space_;
  double smallest_;
  std::vector<double> radii_;
  std::vector<Vector3> centres_;
  std::vector<std::int32_t> next_; ///< of the same cell
  std::vector<Level> levels_;
};

/// The distance of x from the interval [low, high], and from its farther end.
inline std::pair<double, double> distances(double x, double low, double high) {
  return {std::max({0.0, low - x, x - high}), std::max(x - low, high - x)};
}

template <class Take>
void SphereGrid::each_column(const Level &level, const Vector3 &p, double reach, const Take &take) const {
  const bool periodic = space_.sides == Sides::periodic;
  const std::array<double, 2> at{p.x, p.y},
      wide{static_cast<double>(space_.a), static_cast<double>(space_.b)};
  std::array<std::int64_t, 2> low{}, high{};
  for (std::size_t axis = 0; axis < 2; ++axis) {
    low[axis] = static_cast<std::int64_t>(std::floor((at[axis] - reach) / level.cell[axis]));
    high[axis] = static_cast<std::int64_t>(std::floor((at[axis] + reach) / level.cell[axis]));
    if (!periodic) {
      low[axis] = std::max<std::int64_t>(low[axis], 0);
      high[axis] = std::min(high[axis], level.n[axis] - 1);
    }
  }
  // The number of the period that a cell is in, rounded down.
  const auto period = [](std::int64_t i, std::int64_t n) { return i >= 0 ? i / n : -((n - 1 - i) / n); };
  for (std::int64_t j = low[1]; j <= high[1]; ++j) {
    const auto y =
        distances(p.y, static_cast<double>(j) * level.cell[1], static_cast<double>(j + 1) * level.cell[1]);
    const std::int64_t period_y = period(j, level.n[1]);
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      const auto x =
          distances(p.x, static_cast<double>(i) * level.cell[0], static_cast<double>(i + 1) * level.cell[0]);
      const double nearest2 = x.first * x.first + y.first * y.first;
      if (nearest2 > reach * reach)
        continue;
      const std::int64_t period_x = period(i, level.n[0]);
      take(Column{(j - period_y * level.n[1]) * level.n[0] + i - period_x * level.n[0],
                  static_cast<double>(period_x) * wide[0], static_cast<double>(period_y) * wide[1], nearest2,
                  x.second * x.second + y.second * y.second});
    }
  }
}

template <class Take>
void SphereGrid::each_in(const Level &level, const Column &column, std::int64_t row, const Take &take) const {
  for (std::int32_t id = level.first[static_cast<std::size_t>(row * level.n[0] * level.n[1] + column.index)];
       id != none; id = next_[static_cast<std::size_t>(id)]) {
    const Vector3 &c = centres_[static_cast<std::size_t>(id)];
    take(id, Vector3{c.x + column.shift_x, c.y + column.shift_y, c.z});
  }
}

template <class Take>
void SphereGrid::each_near(const Vector3 &p, double q, double near, double slack, const Take &take) const {
  for (const Level &level : levels_) {
    if (level.n[2] == 0)
      continue;
    // Centres are in a shell around p: nearer ones would overlap.
    const double outer = q + level.greatest + near + 1, inner = q + level.least - slack - 1;
    each_column(level, p, outer, [&](const Column &column) {
      const double high = std::sqrt(outer * outer - column.nearest2);
      const double hollow2 = inner * inner - column.farthest2;
      const double hollow = inner > 0 && hollow2 > 0 ? std::sqrt(hollow2) : 0;
      const auto row = [&](double z) { return static_cast<std::int64_t>(std::floor(z / level.cell[2])); };
      const std::int64_t last = std::min(row(p.z + high), level.n[2] - 1);
      const std::int64_t hollow_from = row(p.z - hollow) + 1, hollow_to = row(p.z + hollow);
      for (std::int64_t k = std::max<std::int64_t>(row(p.z - high), 0); k <= last; ++k) {
        if (k >= hollow_from && k < hollow_to) {
          k = hollow_to - 1;
          continue;
        }
        each_in(level, column, k, take);
      }
    });
  }
}

template <class Take>
void SphereGrid::each_below(const Vector3 &p, double q, const Take &take) const {
  double of_interest = q;
  for (auto level = levels_.rbegin(); level != levels_.rend(); ++level) {
    const double reach = q + level->greatest;
    const double top = std::min(p.z / level->cell[2], static_cast<double>(level->n[2] - 1));
    each_column(*level, p, reach, [&](const Column &column) {
      const double high = std::sqrt(std::max(0.0, reach * reach - column.nearest2));
      for (auto k = static_cast<std::int64_t>(std::floor(top));
           k >= 0 && static_cast<double>(k + 1) * level->cell[2] + high >= of_interest; --k)
        each_in(*level, column, k,
                [&](std::int32_t id, const Vector3 &centre) { of_interest = take(id, centre); });
    });
  }
}

} // namespace mdm::packing
