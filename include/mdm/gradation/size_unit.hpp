#pragma once
/// \file
/// Units of size.

#include <mdm/number/rational.hpp>

namespace mdm {

/// The unit that a gradation's sizes are kept in. Inches, phi and sieve names are converted to mm when read.
enum class SizeUnit { mm, um, m };

/// `mm`, `um` or `m`.
std::string_view name(SizeUnit unit);

/// The unit's length in mm.
Rational in_mm(SizeUnit unit);

} // namespace mdm
