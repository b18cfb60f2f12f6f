#pragma once
/// \file
/// Gradations as canonical CSV.

#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// Reads the table of a CSV gradation; the grammar is in proofs/certificate-format.md, section 4.
/// \param content text that Source::check_text has passed, without byte order mark
/// \throws InputError with the line
Table read_csv(std::string_view content, const Source &source, const std::string &id, PhiReading phi);

/// The same of a gradation by number: after the sizes it has one of the number_columns, and nothing else.
Table read_number_csv(std::string_view content, const Source &source, const std::string &id);

/// The same of a gradation of several materials, which the column material names.
Table read_material_csv(std::string_view content, const Source &source, const std::string &id);

/// True where the header has the column material and a canonical column of sizes, also in the wrong order.
bool is_material_csv(std::string_view content);

/// True where the header is that of canonical CSV with one of the number_columns.
bool is_number_csv(std::string_view content);

/// True where the first line that is no comment begins with the name of a canonical column of sizes, so that
/// it is a header of that grammar, or a wrong one; also where there is no such line.
bool is_canonical_csv(std::string_view content);

} // namespace mdm
