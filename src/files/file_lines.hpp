#pragma once
/// \file
/// Files as lines, in bounded memory.

#include "files/byte_source.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Lines of a file or of standard input, as they come in and in bounded memory. A pipe is read once: who
/// looks at its beginning can take the rest as lines or as one text.
class FileLines {
public:
  explicit FileLines(const std::string &path) : bytes_(path) {}

  /// For its digest.
  ByteSource &bytes() { return bytes_; }

  /// A line without its end; nothing of a line that was longer than `longest_line`.
  using Line = std::optional<std::string>;
  /// True of a line that has white space alone.
  static bool is_blank(const Line &line) {
    return line && line->find_first_not_of(" \t\r") == std::string::npos;
  }
  static constexpr std::size_t longest_line = std::size_t{64} << 20;
  /// The mistake of `what` that is longer, such as `the line`.
  static std::string too_long(const std::string &what);

  /// The beginning of what is not taken yet, after one more read; at the end of the input all of it.
  std::string_view look_further();
  bool is_at_end() const { return at_end_; }
  /// What is not taken yet, to the end of the input.
  /// \throws InputError if it has more than `most` bytes
  std::string rest(std::size_t most);

  /// The lines that are there, at least one and at most `most`; waits only for the first. Empty at the end of
  /// the input.
  std::vector<Line> next(std::size_t most);

private:
  void fill();
  bool take_line(std::vector<Line> &lines);

  ByteSource bytes_;
  std::string buffer_;
  std::size_t taken_ = 0;    // of the buffer
  std::size_t searched_ = 0; // no line end before it
  bool skipping_ = false;    // inside a line that is too long
  bool at_end_ = false;
};

} // namespace mdm
