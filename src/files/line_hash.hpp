#pragma once
/// \file
/// The hashes that a LineSum adds up.

#include "answer/line_sum.hpp"
#include "files/digest.hpp"
#include "files/file_lines.hpp"

#include <string>

namespace mdm {

/// The SHA-256 of lines with their numbers. One thread at a time.
class LineHash {
public:
  /// \param number of those of the suite that are not blank, from 1
  /// \param line   without it the line was too long: all such are alike
  LineSum::Hash of(std::uint64_t number, const FileLines::Line &line) {
    digest_.add(std::to_string(number) + (line ? ":" : " is too long"));
    digest_.add(line.value_or(""));
    return digest_.take();
  }

private:
  Digest digest_;
};

} // namespace mdm
