#pragma once

#include <string>

namespace mdm_check {

/// A file to be judged, and the name under which messages speak of it.
struct Input {
  std::string name, text;
};

/// What the program exits with, and the one line that it writes.
struct Verdict {
  enum Code { accepted = 0, refused = 1, malformed = 2 } code;
  std::string line;
};

/// Judges a certificate against a gradation. Throws nothing of its own; memory may run out.
Verdict check(const Input &gradation, const Input &certificate);

} // namespace mdm_check
