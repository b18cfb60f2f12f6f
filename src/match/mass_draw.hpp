#pragma once
/// \file
/// Particle masses drawn uniform by volume.

#include <mdm/gradation/mass_law.hpp>

#include <cstdint>
#include <vector>

namespace mdm {

/// The masses of particles whose sizes are uniform by volume fraction on [l, u] (Voivret, Delenne, Radjai,
/// Eq. 2-4, with the mass law x^e, e = a/b, for the volume): every interval of sizes of the same width holds
/// the same mass, the number density is proportional to x^-e. With V = (u/l)^(e-1) the size of the partition
/// function's value y is x with (u/x)^(e-1) = V - y (V - 1); for e = 1 it is l (u/l)^y.
class MassDraw {
public:
  /// Masses from `least` to `most`. \pre 0 < least <= most
  MassDraw(Integer least, Integer most, const MassLaw &law);

  /// The mass at y = (2 r + 1) / 2^65, with a relative error of some 2^-60 or of 2^-60 of the interval;
  /// least <= mass <= most. Integers alone: the same on every machine.
  Integer operator()(std::uint64_t r) const;

private:
  Integer drawn(std::uint64_t r) const;

  Integer least_, most_;
  MassLaw law_;
  unsigned places_ = 64;       ///< binary ones of what follows
  Integer top_;                ///< V
  Integer scaled_;             ///< most^|a - b|, with places_ a places for a > b
  std::vector<Integer> roots_; ///< for a = b: (most / least)^(1/2), ^(1/4), ...
};

} // namespace mdm
