#pragma once

#include "gradation.hpp"

#include <string>

namespace mdm::checker {

/// The gradation as canonical CSV (section 8), which reads as the same. Throws Malformed where a number needs
/// more digits than the reader takes.
std::string canonical_csv(const Gradation &gradation);

/// The opening x of Y = x^root as the file has it, in its unit, or as its phi; `pan` for the pan of phi.
std::string opening_text(const Gradation &gradation, const mpq_class &Y);

} // namespace mdm::checker
