#pragma once
/// \file
/// Packing files, read.

#include "packing/packing.hpp"

#include <string_view>

namespace mdm {

/// True for a text that begins as packing files do.
bool is_packing(std::string_view text);

/// Reads what write_packing writes. Lengths, supports and the fingerprint of the radii are checked; whether
/// discs overlap is not.
/// \param file for messages
/// \throws InputError `file:line: what is wrong and what to do`
Packing read_packing(std::string_view text, std::string_view file);

} // namespace mdm
