#pragma once
/// \file
/// The description of a sediment as text, JSON and CSV.

#include "soil/sediment.hpp"

namespace mdm {

// `digits` >= 1 are significant digits.

/// One line of JSON, schema `mdm-sediment-1`, without a newline at its end. Numbers are enclosures
/// ["lo","hi"], or null where they are not available (the notes say why).
std::string sediment_json(const SedimentDescription &s, unsigned digits);

/// item,unit,lo,hi,text: a row a number, a mode or a fraction; the word for a number in the last column.
std::string sediment_csv(const SedimentDescription &s, unsigned digits);

/// For people: certain digits, rounded.
std::string sediment_text(const SedimentDescription &s, unsigned digits);

/// A table of several samples with a line each, and their notes.
std::string sediments_text(const std::vector<SedimentDescription> &all, unsigned digits);
/// A line a sample: id, then lo, hi and word of each measure of both methods, lo and hi of Trask's, the
/// textures, lo and hi of each fraction in percent; empty where it is not available. \pre there is one
std::string sediments_csv(const std::vector<SedimentDescription> &all, unsigned digits);

} // namespace mdm
