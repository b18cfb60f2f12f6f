#pragma once

#include "gradation.hpp"

#include <string>

namespace mdm::checker {

/// The gradation as canonical CSV (section 8), which reads as the same. Throws Malformed where a number needs
/// more digits than the reader takes.
std::string canonical_csv(const Gradation &gradation);

} // namespace mdm::checker
