#pragma once
/// \file
/// The shares of groups of grains in bands of height.

#include <mdm/number/interval.hpp>

#include <array>
#include <optional>
#include <vector>

namespace mdm::packing {

inline constexpr std::size_t sphere_bands = 10;

/// A volume of each band, or a share; 0 or more.
using BandVolumes = std::array<Interval, sphere_bands>;

/// Encloses y / z. \pre z > 0
Interval quotient(const Interval &y, const Interval &z);

/// Each group's share of the volume of each band; 0 of a band with nothing in it.
std::vector<BandVolumes> shares_of_bands(const std::vector<BandVolumes> &groups);

/// The intensity of segregation, see SphereTexture::segregation; nothing if there are fewer than two groups.
std::optional<Interval> segregation(const std::vector<BandVolumes> &groups);

} // namespace mdm::packing
