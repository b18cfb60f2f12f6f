#pragma once
/// \file
/// The shapes of the beta curve with given C_u and C_c: what is asked.

#include "ask/generate.hpp"
#include "sets/inverse_model.hpp"

namespace mdm {

/// True if an option of it is given.
bool asks_for_shapes(const GenerateTexts &asked);

/// \throws InputError naming the option or the file
InverseTask inverse_task(const GenerateTexts &asked, const ReadCurve &read);

} // namespace mdm
