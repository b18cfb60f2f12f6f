#pragma once
/// \file
/// Lengths as users write them, with a unit or without one.

#include <mdm/gradation/gradation.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// A number with its unit, or one that is in the unit of a file to come.
struct Length {
  Rational value;
  std::optional<SizeUnit> unit;

  /// The number of that unit.
  Rational in(SizeUnit target) const;
  /// The number of the gradation's unit, mm of phi.
  /// \throws InputError if it has no unit, and the gradation's file has inches
  Rational in(const Gradation &g) const;
};

/// Reads `50mm`, `63um`, `0.5in`, `2m` or `50`.
/// \throws InputError if it is none of them, or not above 0
Length parse_length(std::string_view text);
/// Reads lengths with an x between them: `50mmx100mm`. \throws InputError as parse_length
std::vector<Length> parse_lengths(std::string_view text);

} // namespace mdm
