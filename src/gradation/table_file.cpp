#include "gradation/table_file.hpp"

#include "gradation/camsizer_reader.hpp"
#include "gradation/lab_table.hpp"
#include "gradation/mastersizer_reader.hpp"
#include "gradation/table_columns.hpp"
#include "gradation/upright.hpp"
#include "gradation/workbook.hpp"
#include "text/option_name.hpp"
#include "text/short_list.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace mdm {

void check_one_sample(const Reading &reading, const Source &source) {
  if (reading.specimen)
    source.refuse(1,
                  option("specimen-id") +
                      " is for AGS4 files and others of several samples; this one holds a single gradation");
}

Table read_text_table(std::string_view text, const Source &source, const std::string &id,
                      const Reading &reading) {
  const std::size_t skip =
      static_cast<std::size_t>(std::min<std::uint64_t>(reading.skip.value_or(0), text.size()));
  std::optional<Cells> first;
  for (const char delimiter : {'\t', ';', ','}) {
    if (text.find(delimiter) == std::string_view::npos)
      continue;
    Cells cells = cells_of_text(text, delimiter, skip, source);
    if (is_mastersizer(cells))
      return read_mastersizer(cells, source, id, reading);
    check_one_sample(reading, source);
    const std::optional<std::size_t> header =
        delimiter == '\t' && !reading.describes_table() ? camsizer_header(cells) : std::nullopt;
    if (header)
      return read_camsizer(cells, *header, source, id);
    if (find_columns(cells, reading, source))
      return read_lab_table(cells, source, id, reading);
    if (const std::optional<Cells> turned = upright(cells, source);
        turned && find_columns(*turned, reading, source))
      return read_lab_table(*turned, source, id, reading);
    if (!first)
      first = std::move(cells);
  }
  refuse_table(first ? *first : cells_of_text(text, ',', skip, source), reading, source);
}

namespace {

Table table_of_sheet(Cells cells, const Source &source, const std::string &id, const Reading &reading) {
  if (reading.skip)
    cells.rows.erase(cells.rows.begin(),
                     std::find_if(cells.rows.begin(), cells.rows.end(),
                                  [&](const CellRow &row) { return row.line > *reading.skip; }));
  if (is_mastersizer(cells))
    return read_mastersizer(cells, source, id, reading);
  check_one_sample(reading, source);
  const std::optional<Cells> turned =
      find_columns(cells, reading, source) ? std::nullopt : upright(cells, source);
  const bool is_turned = turned && find_columns(*turned, reading, source);
  return read_lab_table(is_turned ? *turned : cells, source, id, reading);
}

} // namespace

std::optional<std::string> note_on_other_sheets(std::string_view bytes, const std::string &sheet,
                                                const std::string &remedy, const Source &source) {
  ShortList others;
  for (const std::string &name : written_sheets(bytes, source))
    if (name != sheet)
      others.add(name);
  if (others.empty())
    return std::nullopt;
  return fmt::format("Other sheets of the workbook are not read: {}; {}.", others.text(), remedy);
}

Table read_sheet_table(std::string_view bytes, const Source &source, const std::string &file_id,
                       const Reading &reading) {
  Cells cells = read_workbook(bytes, reading.sheet, source);
  const std::string sheet = cells.sheet;
  Table table =
      table_of_sheet(std::move(cells), source, sheet.empty() ? file_id : file_id + "/" + sheet, reading);
  if (!sheet.empty() && !reading.sheet)
    if (const std::optional<std::string> note =
            note_on_other_sheets(bytes, sheet, option("sheet") + " chooses one", source))
      table.notes.push_back(*note);
  return table;
}

} // namespace mdm
