#pragma once
/// \file
/// Gradations in files that are tables, but no canonical CSV: of laboratories and of instruments.

#include "gradation/table.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// The table in a text whose cells stand between tabs, semicolons or commas: that of an instrument, or with
/// the first of them that gives a header.
/// \param text that Source::check_text has passed, without byte order mark
/// \throws InputError with the line
Table read_text_table(std::string_view text, const Source &source, const std::string &id,
                      const Reading &reading);

/// The table in a sheet of a workbook.
/// \throws InputError with the row
Table read_sheet_table(std::string_view bytes, const Source &source, const std::string &id,
                       const Reading &reading);

/// Refuses `--specimen-id` of a file with one sample.
void check_one_sample(const Reading &reading, const Source &source);

/// A note on the sheets of a workbook that were not chosen and in which something is written; nothing if
/// there is none. \param remedy  what to do about them
std::optional<std::string> note_on_other_sheets(std::string_view bytes, const std::string &sheet,
                                                const std::string &remedy, const Source &source);

} // namespace mdm
