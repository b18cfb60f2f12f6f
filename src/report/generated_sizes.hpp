#pragma once
/// \file
/// The sizes of a set as text, handed on in parts: any number of them in bounded memory.

#include <mdm/report/generated.hpp>

namespace mdm {

/// Rows class,size_lo,size_hi.
void write_sizes_csv(const GeneratedSet &set, const Draws &draws, const Sink &sink);

/// "p/q" or ["lo","hi"], separated by commas.
void write_sizes_json(const GeneratedSet &set, const Draws &draws, const Sink &sink);

} // namespace mdm
