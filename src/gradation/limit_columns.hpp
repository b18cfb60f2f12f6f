#pragma once
/// \file
/// Tables of an envelope as specifications have them.

#include <mdm/gradation/envelope.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// The envelope in a table with a column of sizes, one of lower and one of upper limits of the percent that
/// passes, such as `Sieve (mm)`, `Lower` and `Upper`; nothing where there are no such headers.
/// \param content text in any usual encoding, or a workbook
/// \throws InputError `file:line: what is wrong and what to do`
std::optional<Envelope> envelope_in_table(std::string_view content, const std::string &file);

/// True for the header of a column of lower or upper limits, such as `Min % passing`.
bool is_limit(std::string_view header);

} // namespace mdm
