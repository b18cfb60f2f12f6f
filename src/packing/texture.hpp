#pragma once
/// \file
/// What is known of a packing.

#include "packing/contacts.hpp"
#include "packing/packing_fraction.hpp"

#include <map>

namespace mdm {

/// Discs by the number of others that they touch.
using Coordination = std::map<std::uint32_t, std::uint64_t>;

/// 2 contacts / discs. \pre there is a disc
Rational mean_coordination(const Coordination &coordination);

/// Discs whose centres are in a range of heights.
struct HeightBand {
  Rational from, to; ///< in units of the packing
  std::uint64_t discs = 0;
  Rational mean_diameter = 0; ///< weighted by area
};

/// Cells of the contact graph by their corners.
struct CellCounts {
  std::uint64_t triangles = 0, quadrangles = 0, pentagons = 0, larger = 0;

  std::uint64_t total() const { return triangles + quadrangles + pentagons + larger; }
};

/// What is known of a packing, each number exact or enclosed.
struct PackingTexture {
  PackingWindow window;         ///< where the fraction is taken
  std::optional<Real> fraction; ///< nothing where the window is empty
  PackingContacts contacts;
  Coordination coordination, inner_coordination; ///< of all discs; of those with centres in the window
  CellCounts cells;
  std::vector<HeightBand> bands; ///< ten of the window, from below; none where it is empty
};

/// Cost: some us a disc.
PackingTexture packing_texture(const Packing &packing);

} // namespace mdm
