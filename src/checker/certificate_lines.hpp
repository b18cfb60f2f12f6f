#pragma once

#include "text.hpp"

#include <string>
#include <string_view>
#include <utility>

namespace mdm::checker {

/// Walks over the lines of a certificate and over the words of each, which one space separates.
class CertificateLines {
public:
  /// \param writer  the command that writes such certificates, for messages
  CertificateLines(std::string_view text, const char *writer) : writer_(writer), rest_(text) { next(); }

  void check(bool holds, const char *what) const { demand_form(holds, line_, what); }
  /// The number of the line that was read last.
  void check_before(bool holds, const char *what) const { demand_form(holds, before_, what); }
  const char *here() const { return line_.data(); }
  bool more() const { return !line_.empty(); }
  bool begins_with(std::string_view words) const {
    return line_.starts_with(words) && (line_.size() == words.size() || line_[words.size()] == ' ');
  }
  /// Whether the line begins with these words; if so, steps behind them.
  bool take(std::string_view words) {
    const bool yes = begins_with(words);
    line_.remove_prefix(yes ? words.size() : 0);
    return yes;
  }
  void demand(std::string_view words) {
    if (!take(words))
      throw Malformed(line_, quoted(line_) + " instead of the line " + quoted(words) + ": let " + writer_ +
                                 " --proof write it again");
  }
  /// The line must be used up; steps to the next one.
  void end() {
    check(line_.empty(), "too much on this line: drop what follows its numbers");
    next();
  }
  void end_file() const { check(line_.empty() && rest_.empty(), "something follows `end`: drop it"); }

protected:
  std::string_view word() {
    check(more(), "the line is too short: give all its numbers");
    line_.remove_prefix(1);
    const std::string_view word = line_.substr(0, line_.find(' '));
    line_.remove_prefix(word.size());
    return word;
  }
  std::string_view line_; ///< what is left of it

private:
  void next() {
    const std::size_t end = rest_.find('\n');
    before_ = std::exchange(begin_, rest_);
    line_ = rest_.substr(0, end);
    demand_form(end != std::string_view::npos, rest_, "the certificate breaks off: end it with a line `end`");
    rest_.remove_prefix(end + 1);
  }

  const char *writer_;
  std::string_view rest_;
  std::string_view begin_, before_; ///< of this line and the one before it, to the end of the file
};

} // namespace mdm::checker
