#pragma once
/// \file
/// How the readers of gradation files speak.

#include <mdm/error.hpp>
#include <mdm/number/rational.hpp>

#include <string>
#include <vector>

namespace mdm {

/// Where a text comes from, for messages.
class Source {
public:
  /// \param name      of the file, or what else precedes messages
  /// \param has_lines false where the text is itself one line of `name`, so that its line numbers mean
  /// nothing
  explicit Source(std::string_view name, bool has_lines = true) : name_(name), has_lines_(has_lines) {}

  /// Throws the InputError `name:line: what`.
  [[noreturn]] void refuse(std::size_t line, const std::string &what) const;

  /// Refuses more than max_gradation_bytes.
  void check_length(std::string_view content) const;

  /// Refuses text that is too long, is not UTF-8, or holds control characters other than tab, CR and LF.
  void check_text(std::string_view content) const;

private:
  std::string_view name_;
  bool has_lines_;
};

/// r as a message shows it: exact if it is short, else its first digits.
std::string shown(const Rational &r);

/// The items of a list of which only the first few are kept, for a message.
class ShortList {
public:
  void add(std::string_view item);
  bool empty() const { return total_ == 0; }
  std::size_t size() const { return total_; }
  /// `'a', 'b' and 7 more`.
  std::string text() const;

private:
  static constexpr std::size_t kept = 10;
  std::vector<std::string> first_;
  std::size_t total_ = 0;
};

/// The number of the line of `content` that holds the byte `position`, counted from 1.
std::size_t line_number(std::string_view content, std::size_t position);

} // namespace mdm
