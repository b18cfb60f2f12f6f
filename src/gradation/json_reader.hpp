#pragma once
/// \file
/// Gradations as JSON.

#include "text/source.hpp"

#include <mdm/gradation/gradation.hpp>

#include <optional>

namespace mdm {

/// Reads a JSON gradation; the grammar is in proofs/certificate-format.md, section 4.
/// \param content     text that Source::check_text has passed, without byte order mark
/// \param fallback_id the id where the object has none
/// \param round       significant digits to which the masses are taken
/// \param is_named    the gradation is to have a name: an empty id is none
/// \throws InputError with the line, the key and the index in its array
Gradation read_json(std::string_view content, const Source &source, const std::string &fallback_id,
                    std::optional<unsigned> round = std::nullopt, bool is_named = false);

} // namespace mdm
