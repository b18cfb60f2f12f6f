#pragma once
/// \file
/// Characters that sheets write in more than one way.

#include <span>
#include <string>
#include <string_view>

namespace mdm {

/// A way to write something, and the plain one.
struct Spelling {
  std::string_view written, plain;
};

/// `text` in small letters, with all that is in the list, as it is written there, spelled plainly.
std::string spelled_plainly(std::string_view text, std::span<const Spelling> spellings);

} // namespace mdm
