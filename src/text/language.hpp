#pragma once
/// \file
/// The languages that pictures and reports speak.

namespace mdm {

/// Of a document's own words; names, notes and remarks stay as they are.
enum class Language { english, german };

} // namespace mdm
