#pragma once

#include "text.hpp"

#include <string>

namespace mdm_check {

/// What the program exits with, and the one line that it writes.
struct Verdict {
  enum Code { accepted = 0, refused = 1, malformed = 2 } code;
  std::string line;
};

/// Judges a certificate against a gradation. Throws nothing of its own; memory may run out.
Verdict check(const Input &gradation, const Input &certificate);

} // namespace mdm_check
