#pragma once
/// \file
/// The origin of a text, and the checks that any text must pass.

#include <mdm/text/error.hpp>

namespace mdm {

/// The origin of a text, for messages.
class Source {
public:
  /// \param name      of the file, or what else precedes messages
  /// \param has_lines false where the text is itself one line of `name`, so that its line numbers mean
  /// nothing
  explicit Source(std::string_view name, bool has_lines = true) : name_(name), has_lines_(has_lines) {}

  /// Throws the InputError `name:line: what`.
  [[noreturn]] void refuse(std::size_t line, const std::string &what) const;

  /// Refuses the text of a gradation with more bytes than `most`.
  void check_length(std::string_view content, std::size_t most) const;

  /// Refuses a CR that no LF follows: what is behind it would look like a line of its own, but be none.
  void check_line_ends(std::string_view content) const;

  /// Refuses text that is too long, is not UTF-8, holds control characters other than tab, CR and LF, a line
  /// separator or a mark of the direction of writing, or a CR that no LF follows.
  void check_text(std::string_view content, std::size_t most) const;

private:
  std::string_view name_;
  bool has_lines_;
};

/// The number of the line of `content` that holds the byte `position`, counted from 1.
std::size_t line_number(std::string_view content, std::size_t position);

} // namespace mdm
