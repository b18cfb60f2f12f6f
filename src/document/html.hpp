#pragma once
/// \file
/// Text as HTML.

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// Any text as the content of an element or of an attribute in double quotes, control characters escaped.
std::string html_text(std::string_view text);

/// A table of HTML, built up line by line. Cells are text; from the second column on they are numbers, which
/// stand on the right.
class HtmlTable {
public:
  explicit HtmlTable(std::string_view caption, const std::vector<std::string> &titles);
  /// \pre as many cells as titles  \param kind  a class of the line, such as `fail`; may be empty
  void add(const std::vector<std::string> &cells, std::string_view kind = "");
  std::string html() const { return html_ + "</tbody></table>\n"; }

private:
  std::string html_;
};

} // namespace mdm
