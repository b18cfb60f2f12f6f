#pragma once
/// \file
/// Numbers of things in words.

#include <mdm/number/integer.hpp>

#include <string>

namespace mdm {

/// `1 particle`, `2 particles`.
inline std::string counted(const Integer &n, const std::string &one = "particle") {
  return to_string(n) + " " + one + (n == 1 ? "" : "s");
}

} // namespace mdm
