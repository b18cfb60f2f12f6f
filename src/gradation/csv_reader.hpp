#pragma once
/// \file
/// Gradations as CSV.

#include "text/source.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// Reads a CSV gradation; the grammar is in proofs/certificate-format.md, section 4.
/// \param content text that Source::check_text has passed, without byte order mark
/// \throws InputError with the line
Gradation read_csv(std::string_view content, const Source &source, const std::string &id, PhiReading phi);

} // namespace mdm
