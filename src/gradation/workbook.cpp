#include "gradation/workbook.hpp"

#include "gradation/archive.hpp"
#include "gradation/cell_double.hpp"
#include "gradation/workbook_styles.hpp"
#include "gradation/xml_tree.hpp"
#include "text/option_name.hpp"
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

  std::vector<std::string> written_sheets() {
    std::vector<std::string> names;
    for_each_sheet([&](const std::string &name, const std::string &path) {
      const Part sheet(archive_, path, source_);
      bool is_written = false;
      for_each_below(sheet.root(), "c",
                     [&](pugi::xml_node cell) { is_written |= !cell.first_child().empty(); });
      if (is_written)
        names.push_back(name);
    });
    return names;
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

  /// Calls `visit` with the name and path of every sheet that holds cells, those first that are shown.
  template <class Visit>
  void for_each_sheet(Visit visit) {
    const Part book(archive_, "xl/workbook.xml", source_);
    const Part relations(archive_, "xl/_rels/workbook.xml.rels", source_);
    if (!book.root() || !relations.root())
      source_.refuse(1, "this zip archive is no workbook (.xlsx): unpack it and give the file in it");
    for (const bool are_hidden : {false, true})
      for_each_below(child_of(book.root(), "sheets"), "sheet", [&](pugi::xml_node sheet) {
        const std::string_view state = sheet.attribute("state").value();
        if ((state == "hidden" || state == "veryHidden") != are_hidden)
          return;
        std::string path;
        for (const pugi::xml_attribute attribute : sheet.attributes())
          if (local_name(attribute.name()) == "id" && std::string_view(attribute.name()) != "id")
            path = path_of(relations.root(), attribute.value());
        if (!path.empty()) // else it is a chart
          visit(std::string(sheet.attribute("name").value()), path);
      });
  }

  std::string sheet_path(const std::optional<std::string> &wanted) {
    std::string found;
    ShortList names;
    for_each_sheet([&](const std::string &name, const std::string &path) {
      names.add(name);
      if (found.empty() && (!wanted || *wanted == name)) {
        found = path;
        name_ = name;
      }
    });
    if (found.empty())
      source_.refuse(1, fmt::format("there is no sheet {}: {} takes one of {}",
                                    in_quotes(wanted.value_or("")), option("sheet"), names.text()));
    if (names.size() > 1) {
      cells_.sheet = name_;
      cells_.hint = fmt::format("; or choose another sheet with {}: {}", option("sheet"), names.text());
    }
    return found;
  }

  void read_strings() {
    const Part part(archive_, "xl/sharedStrings.xml", source_);
    for (const pugi::xml_node item : part.root().children())
      if (local_name(item.name()) == "si")
        strings_.push_back(string_of(item));
  }

  /// True where a run is raised, lowered or struck out: its digits are none of the number before it.
  static bool stands_apart(pugi::xml_node run) {
    const pugi::xml_node style = child_of(run, "rPr");
    const std::string_view place = child_of(style, "vertAlign").attribute("val").value();
    return place == "superscript" || place == "subscript" || child_of(style, "strike");
  }

  /// The text of a string, in one piece or in runs; not what is said of its pronunciation. A run that stands
  /// apart is in brackets behind a ^, so that no number is made of it.
  static std::string string_of(pugi::xml_node item) {
    std::string text;
    for (const pugi::xml_node part : item.children()) {
      if (local_name(part.name()) == "t")
        text += text_below(part);
      else if (local_name(part.name()) == "r")
        text += stands_apart(part) ? "^(" + text_below(child_of(part, "t")) + ")"
                                   : text_below(child_of(part, "t"));
    }
    return text;
  }

  void read_row(pugi::xml_node row) {
    const std::size_t number = whole(row.attribute("r").value()).value_or(row_ + 1);
    if (number <= row_ || number > max_rows)
      source_.refuse(number, "the rows of the sheet are not in order: save the workbook again");
    CellRow cells{number, number > last_ + 1, {}};
    cells.is_hidden = row.attribute("hidden").as_bool();
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
    row.cells.push_back(cell_text(cell, row));
  }

  /// The text of the next cell of the row.
  std::string cell_text(pugi::xml_node cell, CellRow &row) {
    const std::string_view type = cell.attribute("t").value();
    const std::string value = text_below(child_of(cell, "v"));
    if (child_of(cell, "f") && value.empty() && (type != "str" || !child_of(cell, "v")))
      source_.refuse(row.line,
                     "a cell has a formula without its value: open the workbook in a spreadsheet and save "
                     "it");
    if (type.empty() || type == "n")
      return number_text(value, cell.attribute("s").as_uint(), row);
    row.texts.push_back(row.cells.size());
    if (type == "inlineStr")
      return std::string(without_spaces(string_of(child_of(cell, "is"))));
    if (type == "b") // as the sheet shows it: no number
      return value == "0" ? "FALSE" : "TRUE";
    if (type != "s")
      return std::string(without_spaces(value));
    const std::optional<std::size_t> index = whole(value);
    if (!index || *index >= strings_.size())
      source_.refuse(row.line, "a cell has a text that is not in the workbook: save it again");
    return std::string(without_spaces(strings_[*index]));
  }

  /// A number with what its format shows around it: a percent sign, a unit, the sign of a sieve's number.
  std::string number_text(const std::string &value, std::size_t style, CellRow &row) const {
    const std::optional<CellDouble> number = cell_double(value);
    if (!number)
      return value;
    const CellStyle shown = style < styles_.size() ? styles_[style] : CellStyle();
    if (shown.kind == CellKind::date)
      return std::string(date_cell);
    if (!number->is_short)
      row.long_numbers.push_back(row.cells.size());
    const std::string digits =
        shown.kind == CellKind::percent ? to_decimal(parse_decimal(number->text) * 100) + "%" : number->text;
    return std::string(without_spaces(shown.before + digits + shown.behind));
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

std::vector<std::string> written_sheets(std::string_view bytes, const Source &source) {
  return Workbook(bytes, source).written_sheets();
}

} // namespace mdm
