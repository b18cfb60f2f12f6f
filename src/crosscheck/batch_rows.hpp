#pragma once
/// \file
/// The answers of mdm batch in CSV, which have a row a class.

#include "crosscheck/other_answer.hpp"

#include <string_view>

namespace mdm {

/// True of the header of such a table, in whatever unit.
bool is_batch_header(std::string_view line);

/// Reads such a table: the rows of an answer follow each other, from class 1 on.
/// \throws InputError `file:line: ...` if a row is none of it
std::vector<OtherAnswer> read_batch_rows(std::string_view content, const std::string &file);

} // namespace mdm
