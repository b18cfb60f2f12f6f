#pragma once
/// \file
/// Tables for people, and fields for CSV.

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Lines of as many cells; columns are as wide as their longest cell in characters, two spaces before each,
/// flush left where `alignment` has `<` and flush right where it has `>`; its last letter stands for all
/// further columns. No line ends with spaces.
std::string text_table(const std::vector<std::vector<std::string>> &lines, std::string_view alignment);

/// The same, built up entry by entry below a line of titles.
class TextTable {
public:
  /// A column with its title; before the first line. \param align < flush left, > flush right
  void add_column(const std::string &title, char align);
  void add_line() { lines_.emplace_back(); }
  /// The next entry of the last line.
  void add(const std::string &entry) { lines_.back().push_back(entry); }

  std::string text() const { return text_table(lines_, alignment_); }

private:
  std::vector<std::vector<std::string>> lines_ = {{}}; ///< the first has the titles
  std::string alignment_;
};

/// Any text as a field of CSV: control characters escaped, in quotes where it needs them.
std::string csv_field(std::string_view text);

} // namespace mdm
