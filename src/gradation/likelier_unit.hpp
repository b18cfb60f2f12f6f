#pragma once
/// \file
/// The unit that a sample's sizes may have had.

#include "gradation/description.hpp"
#include "gradation/length.hpp"

namespace mdm {

/// Where all particles, which were read in `unit`, lie outside the classes or in the pan's: a unit with which
/// the first would not; else nothing.
std::optional<SizeUnit> likelier_unit(const Description &d, SizeUnit unit);

} // namespace mdm
