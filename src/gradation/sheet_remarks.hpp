#pragma once
/// \file
/// Numbers below a sheet's table that are about the curve, the soil or the sheet, and no masses.

#include <string_view>

namespace mdm {

/// A number about the whole curve, which labs write below its columns: `Fineness modulus`, `Cu`, `D10 (mm)`,
/// `D60/D10`.
bool names_index(std::string_view cell);

/// A number about the sheet or the soil: `Page`, `Moisture content`. All words must be such words: `Pan
/// content` and `Test sieve 0.063` are none.
bool names_remark(std::string_view cell);

/// The header of a column of words, or the word ahead of a note: `Remarks`, `Bemerkung`.
bool heads_remarks(std::string_view header);

} // namespace mdm
