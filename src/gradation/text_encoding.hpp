#pragma once
/// \file
/// Text in the encodings of laboratories' programs.

#include "text/source.hpp"

#include <optional>

namespace mdm {

/// Text that was not UTF-8, as UTF-8 without byte order mark.
struct DecodedText {
  std::string text;
  std::string encoding; ///< as notes and messages name it
};

/// The text of UTF-16 with a byte order mark, or else of bytes that are not UTF-8: Windows-1252, which holds
/// Latin-1. Nothing for UTF-8 and for what is no text in any of them.
/// \throws InputError with the line where UTF-16 is cut or malformed
std::optional<DecodedText> decoded_text(std::string_view bytes, const Source &source);

} // namespace mdm
