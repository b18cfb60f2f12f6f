#pragma once
/// \file
/// The sizes of a set as text, handed on in parts: any number of them in bounded memory.

#include "answer/generated.hpp"
#include "text/json_writer.hpp"

namespace mdm {

/// Rows class,size_lo,size_hi; the header has the unit of the sizes, if they have one.
void write_sizes_csv(const GeneratedSet &set, const Draws &draws, const Sink &sink);

/// An array of "p/q" or ["lo","hi"].
void write_sizes_json(const GeneratedSet &set, const Draws &draws, JsonWriter &json);

} // namespace mdm
