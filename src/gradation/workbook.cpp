#include "gradation/workbook.hpp"

#include "gradation/archive.hpp"
#include "gradation/cell_double.hpp"
#include "gradation/workbook_styles.hpp"
#include "gradation/xml_tree.hpp"
#include "text/short_list.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <charconv>

namespace mdm {
namespace {

// The limits of spreadsheets themselves.
constexpr std::size_t max_columns = 16384;
constexpr std::size_t max_rows = std::size_t{1} << 20;

std::optional<std::size_t> whole(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    return std::nullopt;
  return value;
}

/// The index of the column of a reference such as `AB12`; nothing where there are no letters.
std::optional<std::size_t> column_of(std::string_view reference) {
  std::size_t column = 0;
  for (const char c : reference) {
    if (c < 'A' || c > 'Z' || column > max_columns)
      break;
    column = column * 26 + static_cast<std::size_t>(c - 'A') + 1;
  }
  return column == 0 ? std::nullopt : std::optional(column - 1);
}

/// A file of the workbook as a tree; without children where there is none.
class Part {
public:
  Part(Archive &archive, const std::string &name, const Source &source) {
    if (std::optional<std::string> text = archive.read(name))
      tree_.emplace(std::move(*text), source, in_quotes(name) + " in the workbook");
  }
  pugi::xml_node root() const { return tree_ ? tree_->root() : pugi::xml_node(); }

private:
  std::optional<XmlTree> tree_;
};

class Workbook {
public:
  Workbook(std::string_view bytes, const Source &source) : archive_(bytes, source), source_(source) {}

  Cells read(const std::optional<std::string> &wanted) {
    const std::string path = sheet_path(wanted);
    read_strings();
    styles_ = cell_styles(Part(archive_, "xl/styles.xml", source_).root());
    const Part sheet(archive_, path, source_);
    if (!sheet.root())
      source_.refuse(1, fmt::format("the sheet {} is not in the workbook: save it again", in_quotes(name_)));
    cells_.format = fmt::format("workbook, sheet {}", in_quotes(name_));
    for_each_below(sheet.root(), "row", [this](pugi::xml_node row) { read_row(row); });
    return std::move(cells_);
  }

private:
  /// The path of a sheet that holds cells, by its relationship.
  std::string path_of(pugi::xml_node relations, std::string_view id) const {
    std::string path;
    for_each_below(relations, "Relationship", [&](pugi::xml_node relation) {
      const std::string_view type = relation.attribute("Type").value();
      if (id == relation.attribute("Id").value() && type.ends_with("/worksheet"))
        path = relation.attribute("Target").value();
    });
    return path.empty() ? path : path.starts_with('/') ? path.substr(1) : "xl/" + path;
  }

  std::string sheet_path(const std::optional<std::string> &wanted) {
    const Part book(archive_, "xl/workbook.xml", source_);
    const Part relations(archive_, "xl/_rels/workbook.xml.rels", source_);
    if (!book.root() || !relations.root())
      source_.refuse(1, "this zip archive is no workbook (.xlsx): unpack it and give the file in it");
    std::string found;
    ShortList names;
    for_each_below(child_of(book.root(), "sheets"), "sheet", [&](pugi::xml_node sheet) {
      const std::string name = sheet.attribute("name").value();
      std::string path;
      for (const pugi::xml_attribute attribute : sheet.attributes())
        if (local_name(attribute.name()) == "id" && std::string_view(attribute.name()) != "id")
          path = path_of(relations.root(), attribute.value());
      if (path.empty())
        return; // a sheet of a chart
      names.add(name);
      if (found.empty() && (!wanted || *wanted == name)) {
        found = path;
        name_ = name;
      }
    });
    if (found.empty())
      source_.refuse(1, fmt::format("there is no sheet {}: --sheet takes one of {}",
                                    in_quotes(wanted.value_or("")), names.text()));
    if (names.size() > 1)
      cells_.hint = fmt::format("; or choose another sheet with --sheet: {}", names.text());
    return found;
  }

  void read_strings() {
    const Part part(archive_, "xl/sharedStrings.xml", source_);
    for (const pugi::xml_node item : part.root().children())
      if (local_name(item.name()) == "si")
        strings_.push_back(string_of(item));
  }

  /// The text of a string, in one piece or in runs; not what is said of its pronunciation.
  static std::string string_of(pugi::xml_node item) {
    std::string text;
    for (const pugi::xml_node part : item.children()) {
      if (local_name(part.name()) == "t")
        text += text_below(part);
      else if (local_name(part.name()) == "r")
        text += text_below(child_of(part, "t"));
    }
    return text;
  }

  void read_row(pugi::xml_node row) {
    const std::size_t number = whole(row.attribute("r").value()).value_or(row_ + 1);
    if (number <= row_ || number > max_rows)
      source_.refuse(number, "the rows of the sheet are not in order: save the workbook again");
    CellRow cells{number, number > last_ + 1, {}};
    row_ = number;
    for (const pugi::xml_node cell : row.children())
      if (local_name(cell.name()) == "c")
        read_cell(cell, cells);
    count_ += cells.cells.size();
    if (count_ > max_cells)
      source_.refuse(number,
                     fmt::format("the sheet has more than {} cells: give the gradation alone", max_cells));
    if (std::all_of(cells.cells.begin(), cells.cells.end(), [](const std::string &c) { return c.empty(); }))
      return;
    last_ = number;
    cells_.rows.push_back(std::move(cells));
  }

  void read_cell(pugi::xml_node cell, CellRow &row) {
    const std::size_t column = column_of(cell.attribute("r").value()).value_or(row.cells.size());
    if (column >= max_columns || column < row.cells.size())
      source_.refuse(row.line,
                     fmt::format("the sheet has a cell beyond column {} or out of order: give the gradation "
                                 "alone",
                                 max_columns));
    row.cells.resize(column);
    row.cells.push_back(cell_text(cell, row.line, column));
  }

  std::string cell_text(pugi::xml_node cell, std::size_t row, std::size_t column) {
    const std::string_view type = cell.attribute("t").value();
    const std::string value = text_below(child_of(cell, "v"));
    if (type == "inlineStr")
      return std::string(without_spaces(string_of(child_of(cell, "is"))));
    if (type == "s") {
      const std::optional<std::size_t> index = whole(value);
      if (!index || *index >= strings_.size())
        source_.refuse(row, "a cell has a text that is not in the workbook: save it again");
      return std::string(without_spaces(strings_[*index]));
    }
    if (!type.empty() && type != "n")
      return std::string(without_spaces(value));
    return number_text(value, cell.attribute("s").as_uint(), row, column);
  }

  std::string number_text(const std::string &value, std::size_t style, std::size_t row, std::size_t column) {
    const std::optional<CellDouble> number = cell_double(value);
    if (!number)
      return value;
    const CellStyle shown = style < styles_.size() ? styles_[style] : CellStyle::plain;
    if (shown == CellStyle::date)
      return "(a date)";
    if (!number->is_short)
      cells_.long_numbers.emplace_back(row, column);
    if (shown == CellStyle::percent)
      return to_decimal(parse_decimal(number->text) * 100) + "%";
    return number->text;
  }

  Archive archive_;
  const Source &source_;
  std::string name_; ///< of the sheet
  std::vector<std::string> strings_;
  std::vector<CellStyle> styles_;
  Cells cells_;
  std::size_t row_ = 0, last_ = 0; ///< the last row, and the last with something in it
  std::size_t count_ = 0;
};

} // namespace

Cells read_workbook(std::string_view bytes, const std::optional<std::string> &sheet, const Source &source) {
  return Workbook(bytes, source).read(sheet);
}

} // namespace mdm
