#pragma once
/// \file
/// The description of a gradation as text, JSON and CSV.

#include "soil/describe.hpp"

namespace mdm {

// `digits` >= 1 are significant digits; openings that are fractions must be decimals, as those of a file are.

/// One line of JSON, schema `mdm-describe-1`, without a newline at its end: id, unit (mm), passing [{size,
/// percent}] (an irrational opening as
/// an enclosure ["lo","hi"]), D10, D30, D50, D60, Cu, Cc, span, D32, D43, FM, FM_EN, kHazen, kKozenyCarman
/// (with a void ratio), IGS, IC, phi1, zeta1, dmax, dmaxD50, diameters [{percent, size}], uscs {symbol, name,
/// fines}, aashto {symbol, name, index}, iso_14688 {symbol, name}, uscs_fractions and iso_14688_fractions
/// [{name, above, up_to, percent}], notes, versions. Index numbers and percents are enclosures ["lo","hi"],
/// D32, D43 and kKozenyCarman ranges; what is not available is null (the notes say why).
std::string description_json(const SoilDescription &d, unsigned digits);

/// item,unit,lo,hi,text: a row an index number or fraction; the group's symbol and name in the last column.
std::string description_csv(const SoilDescription &d, unsigned digits);

/// For people: certain digits, rounded.
std::string description_text(const SoilDescription &d, unsigned digits);

/// Tables of several samples with a line each, and their notes.
std::string descriptions_text(const std::vector<SoilDescription> &all, unsigned digits);
/// A line a sample: id, uscs, aashto, aashto_index, iso_14688, then lo and hi of each index number and of
/// each fraction in percent; empty where it is not available. \pre there is one
std::string descriptions_csv(const std::vector<SoilDescription> &all, unsigned digits);

} // namespace mdm
