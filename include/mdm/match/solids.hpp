#pragma once
/// \file
/// The volume of solids that a sample must have at least.

#include <mdm/gradation/size_unit.hpp>
#include <mdm/number/interval.hpp>

#include <optional>
#include <variant>

namespace mdm {

/// A specimen in a cylinder of diameter D and height H at void ratio e; lengths in the gradation's unit.
struct Cylinder {
  Rational diameter, height, void_ratio;
};
/// A specimen in a box at void ratio e.
struct Box {
  Rational a, b, c, void_ratio;
};
/// A volume of solids, in the cube of the gradation's unit.
struct SolidsVolume {
  Rational volume;
};
/// The demand that sets the least volume of solids.
using Solids = std::variant<Cylinder, Box, SolidsVolume>;

/// Reads `cylinder:DxH` or `box:AxBxC` with its void ratio; lengths may have units, as `cylinder:50mmx0.1m`.
/// \param unit  of the lengths of the result, and of those without a unit
/// \throws InputError if it is anything else, a length is not positive, or the void ratio is negative
Solids parse_specimen(std::string_view shape, std::string_view void_ratio, SizeUnit unit);

/// The shortest length of a specimen, in the gradation's unit; nothing for a volume.
std::optional<Rational> narrowest(const Solids &solids);

/// Digits of pi after the point at which what is still undecided is given up: the limit of certificates.
constexpr unsigned most_pi_places = 1000;

/// The least scale s_0 at which spheres have the volume: s_0 = 6 V / (pi W) with W = sum m_j / c_j. For a
/// cylinder pi cancels and s_0 is known; otherwise it is irrational, strictly between the bounds.
/// \param pi_places  digits of pi after the point
Interval start_scale(const Solids &solids, const Rational &weight, unsigned pi_places);

} // namespace mdm
