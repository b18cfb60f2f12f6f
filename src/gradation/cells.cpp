#include "gradation/cells.hpp"

#include "gradation/cell_numbers.hpp"
#include "text/lines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::array<std::string_view, 5> spaces = {" ", "\t", "\u00A0", "\u202F", "\u2009"};

std::string_view name(char delimiter) {
  return delimiter == '\t' ? "tabs" : delimiter == ';' ? ";" : ",";
}

bool is_empty(const std::vector<std::string> &cells) {
  return std::all_of(cells.begin(), cells.end(), [](const std::string &c) { return c.empty(); });
}

/// False for `#4 (4.75 mm)` and `# 200`: a number behind the # may be that of a sieve. `#N/A,250` is a row of
/// the table, as a number stands in a cell of its own, and so is `#,Sieve,Mass`.
bool is_comment(const std::vector<std::string> &cells) {
  if (!cells[0].starts_with('#'))
    return false;
  const std::string_view behind = without_spaces(std::string_view(cells[0]).substr(1));
  return (behind.empty() || !is_digit(behind.front())) &&
         std::none_of(cells.begin() + 1, cells.end(), [&behind](const std::string &cell) {
           return behind.empty() ? !cell.empty() : number_cell(cell).has_value();
         });
}

/// The cells of a line, without the spaces around them; nothing where a quoted one is not closed.
std::optional<std::vector<std::string>> split(std::string_view line, char delimiter) {
  std::vector<std::string> fields;
  if (delimiter == '\t') { // blanks around a field, of which a tab is one, do not separate here
    for (std::size_t from = 0; from <= line.size();) {
      const std::size_t to = std::min(line.find('\t', from), line.size());
      fields.push_back(unquoted(without_spaces(line.substr(from, to - from))));
      from = to + 1;
    }
    return fields;
  }
  if (!split_fields(line, delimiter, fields))
    return std::nullopt;
  for (std::string &field : fields)
    field = without_spaces(std::string(field));
  return fields;
}

/// The cells of the next line, or of several where a line ends within quotes. What is not closed is one cell.
std::vector<std::string> next_cells(Lines &lines, char delimiter) {
  constexpr int most_lines = 10;
  std::optional<std::vector<std::string>> cells = split(lines.text(), delimiter);
  if (cells)
    return *std::move(cells);
  const std::string first(lines.text());
  std::string all = first;
  Lines ahead = lines;
  for (int i = 1; !cells && i < most_lines && ahead.next(); ++i) {
    all += " " + std::string(ahead.text());
    cells = split(all, delimiter);
    if (cells)
      lines = ahead;
  }
  return cells ? *std::move(cells) : std::vector<std::string>{first};
}

/// `\u22121` with the sign of minus that is not of ASCII.
void make_minus_plain(std::string &cell) {
  constexpr std::string_view minus = "\u2212";
  if (cell.starts_with(minus) && cell.size() > minus.size() && is_digit(cell[minus.size()]))
    cell.replace(0, minus.size(), "-");
}

} // namespace

std::string_view without_spaces(std::string_view text) {
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const std::string_view space : spaces) {
      if (text.starts_with(space)) {
        text.remove_prefix(space.size());
        goes_on = true;
      } else if (text.ends_with(space)) {
        text.remove_suffix(space.size());
        goes_on = true;
      }
    }
  }
  return text;
}

Cells cells_of_text(std::string_view text, char delimiter, std::size_t skip, const Source &source) {
  Cells table{fmt::format("text with {} between cells", name(delimiter)), delimiter, {}, {}};
  std::size_t count = 0;
  bool gap = false;
  for (Lines lines(text); lines.next();) {
    if (lines.number() <= skip)
      continue;
    const std::size_t line = lines.number();
    std::vector<std::string> cells = next_cells(lines, delimiter);
    if (cells.size() >= max_fields)
      source.refuse(line, fmt::format("the row has {} cells or more: give the gradation alone", max_fields));
    std::for_each(cells.begin(), cells.end(), make_minus_plain);
    if (is_empty(cells)) {
      gap = true;
      continue;
    }
    count += cells.size();
    if (count > max_cells)
      source.refuse(line,
                    fmt::format("the table has more than {} cells: give the gradation alone", max_cells));
    if (is_comment(cells)) {
      cells.front().erase(0, cells.front().find_first_not_of("# "));
      table.comments.push_back({line, false, std::move(cells)});
      continue;
    }
    table.rows.push_back({line, gap, std::move(cells)});
    gap = false;
  }
  return table;
}

std::string beginning_of(const Cells &cells) {
  constexpr std::size_t shown_rows = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(cells.rows.size(), shown_rows); ++i) {
    std::string row;
    for (const std::string &cell : cells.rows[i].cells)
      row += (row.empty() ? "" : " | ") + cell;
    text += (text.empty() ? "" : ", ") + in_quotes(row);
  }
  return text;
}

} // namespace mdm
