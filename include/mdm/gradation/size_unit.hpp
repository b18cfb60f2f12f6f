#pragma once
/// \file
/// Units of length.

#include <mdm/number/rational.hpp>

#include <optional>
#include <string_view>

namespace mdm {

/// A unit of sizes and other lengths. No gradation is kept in inches: they, phi and sieve names are converted
/// to mm when read.
enum class SizeUnit { mm, um, m, in };

/// `mm`, `um`, `m` or `in`.
std::string_view name(SizeUnit unit);
/// The unit of that name, or nothing.
std::optional<SizeUnit> parse_size_unit(std::string_view name);

/// The unit's length in mm.
Rational in_mm(SizeUnit unit);

} // namespace mdm
