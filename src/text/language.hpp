#pragma once
/// \file
/// The languages that pictures and reports speak.

namespace mdm {

/// Of a document's own words and notes; names and remarks stay as they are.
enum class Language { english, german };

} // namespace mdm
