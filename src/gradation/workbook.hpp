#pragma once
/// \file
/// Workbooks of spreadsheets (.xlsx).

#include "gradation/cells.hpp"

#include <optional>

namespace mdm {

/// True for a zip archive, which a workbook is.
bool is_workbook(std::string_view bytes);

/// The cells of a sheet, the first that is shown or that of the name; numbers are the shortest decimals of
/// their doubles.
/// \throws InputError if it is no workbook, or larger than max_unpacked_bytes when it is unpacked; or, where the program
/// was built without libzip and pugixml, in any case
Cells read_workbook(std::string_view bytes, const std::optional<std::string> &sheet, const Source &source);

/// The names of the sheets in which something is written, in their order, those first that are shown.
/// \throws InputError as above
std::vector<std::string> written_sheets(std::string_view bytes, const Source &source);

} // namespace mdm
