#pragma once
/// \file
/// Texts with a part changed.

#include "catch.hpp"

#include <string>

namespace mdm_test {

/// The text with `by` in the place of the first `part`, which must be there.
inline std::string replaced(std::string text, const std::string &part, const std::string &by) {
  const std::size_t at = text.find(part);
  REQUIRE(at != std::string::npos);
  return text.replace(at, part.size(), by);
}

} // namespace mdm_test
