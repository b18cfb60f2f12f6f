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
/// stand on the right. A page has room for some columns: where there are more behind the first `heads`, these
/// are repeated in further tables.
class HtmlTable {
public:
  HtmlTable(std::string caption, std::vector<std::string> titles, std::size_t heads = 1)
      : caption_(std::move(caption)), titles_(std::move(titles)), heads_(heads) {}
  /// \pre as many cells as titles  \param kind  a class of the line, such as `fail`; may be empty
  void add(std::vector<std::string> cells, std::string kind = "") {
    lines_.push_back({std::move(cells), std::move(kind)});
  }
  std::string html() const;

private:
  struct Line {
    std::vector<std::string> cells;
    std::string kind;
  };

  /// The table of the heads and the columns from `begin` to `end`.
  std::string part(std::size_t begin, std::size_t end) const;

  std::string caption_;
  std::vector<std::string> titles_;
  std::size_t heads_;
  std::vector<Line> lines_;
};

} // namespace mdm
