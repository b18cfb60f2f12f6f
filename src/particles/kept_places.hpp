#pragma once
/// \file
/// The places that particles of a file have.

#include <array>
#include <cstddef>
#include <vector>

namespace mdm {

/// A particle of a set, where it lies.
struct KeptPlace {
  std::size_t class_index, size_index; ///< in the set
  std::array<double, 3> at;
};

/// Places of all particles of a set, in its unit, from the lower corner of their box on.
struct KeptPlaces {
  std::array<double, 3> box{};
  std::array<bool, 3> periodic{};
  bool has_box = false; ///< the file's; else the smallest around the particles
  std::vector<KeptPlace> particles;
};

} // namespace mdm
