#pragma once
/// \file
/// Lengths as users write them, with a unit or without one.

#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// Units that a length may be written in.
enum class LengthUnit { mm, um, m, in };

/// `mm`, `um`, `m` or `in`.
std::string_view name(LengthUnit unit);
/// The unit of that name, or nothing.
std::optional<LengthUnit> parse_length_unit(std::string_view name);
/// The same unit; no gradation is kept in inches.
LengthUnit length_unit(SizeUnit unit);
/// Its length in mm.
Rational in_mm(LengthUnit unit);

/// A number with its unit, or one that is in the unit of a file to come.
struct Length {
  Rational value;
  std::optional<LengthUnit> unit;

  /// The number of that unit.
  Rational in(SizeUnit target) const;
};

/// Reads `50mm`, `63um`, `0.5in`, `2m` or `50`.
/// \throws InputError if it is none of them, or not above 0
Length parse_length(std::string_view text);
/// Reads lengths with an x between them: `50mmx100mm`. \throws InputError as parse_length
std::vector<Length> parse_lengths(std::string_view text);

} // namespace mdm
