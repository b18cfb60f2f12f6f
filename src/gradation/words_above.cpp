#include "gradation/words_above.hpp"

#include "gradation/column_words.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_words.hpp"
#include "gradation/unused_columns.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// `Results are cumulative`: a sentence about values.
bool states_sums(std::string_view cell) {
  const std::vector<std::string> words = words_of(cell);
  return speaks_of_sums(cell) &&
         has_any_word("is are results result values value mass masses weight weights data numbers sind werte "
                      "massen ergebnisse rueckstaende sont valeurs resultats refus son valores masas "
                      "resultados sono valori masse risultati",
                      words) &&
         !has_any_word("not non no nicht pas passing finer durchgang durchgaenge", words);
}

/// The unit of length that a sentence gives to sizes: `All sizes in micrometres`; none of one with a number,
/// as `Sieves of 8 in`.
ColumnUnit unit_of_sizes(std::string_view cell) {
  if (has_digit(cell))
    return ColumnUnit::none;
  const std::vector<std::string> words = words_of(cell);
  if (words.size() < 3 ||
      !has_any_word("size sizes sieve sieves opening openings siebe siebweiten ouvertures aberturas aperture",
                    words) ||
      !has_two_words("in are en sind sont son sono", words.back(), words))
    return ColumnUnit::none;
  const ColumnUnit unit = unit_of_words(words.back());
  return is_of_sizes(unit) ? unit : ColumnUnit::none;
}

/// `Number` or `Counts` alone.
bool is_number_alone(std::string_view cell) {
  return has_only_words("number numbers count counts frequency anzahl haeufigkeit nombre numero frecuencia",
                        words_of(cell));
}

} // namespace

void check_words_above(const Cells &cells, std::size_t row, const TableColumns &columns,
                       const Source &source) {
  if (row == 0 || cells.rows[row].below_gap)
    return;
  const CellRow &above = cells.rows[row - 1];
  std::size_t place = columns.value;
  while (place > columns.size + 1 && above.cell(place).empty())
    --place;
  const std::string_view words = above.cell(place);
  if (words.empty())
    return;
  const std::optional<HeaderMeaning> with = header_meaning(std::string(words) + " " + columns.value_name);
  const bool are_retained = columns.values.meaning != ColumnMeaning::passing;
  // In the first column it may be a title, beside a label as in `Operator,Number` what that asks.
  const bool is_alone = place > 0 && above.cell(place - 1).empty();
  const bool says_otherwise =
      is_alone && (is_number_alone(words) ||
                   (are_retained ? speaks_of_moisture_or_container(words) : speaks_of_retaining(words)));
  if ((with && with->meaning != columns.values.meaning) || says_otherwise)
    source.refuse(above.line,
                  fmt::format("{} is above the header {}, which means another thing with it: write the whole "
                              "header into one cell",
                              in_quotes(words), in_quotes(columns.value_name)));
}

void check_words_of_sums(const Cells &cells, const TableColumns &columns, const Source &source) {
  const CellRow *header = columns.width == 0 ? nullptr : &cells.rows[columns.above];
  if (columns.values.meaning != ColumnMeaning::retained ||
      (header != nullptr && std::any_of(header->cells.begin(), header->cells.end(), speaks_of_sums)))
    return;
  for (const CellRow &row : cells.rows)
    if (&row != header && std::none_of(row.cells.begin(), row.cells.end(), has_digit))
      for (const std::string &cell : row.cells)
        if (states_sums(cell))
          source.refuse(row.line,
                        fmt::format("{} may say that what is in {} is cumulative: say {} cumulative "
                                    "if it is, else {} retained",
                                    in_quotes(cell), in_quotes(columns.value_name), option("kind"),
                                    option("kind")));
}

void check_words_of_units(const Cells &cells, const TableColumns &columns, const Source &source) {
  if (!is_of_sizes(columns.sizes.unit))
    return;
  for (std::size_t i = 0; i < cells.rows.size(); ++i)
    if (i < columns.above || i >= columns.first_row)
      for (const std::string &cell : cells.rows[i].cells)
        if (const ColumnUnit unit = unit_of_sizes(cell);
            unit != ColumnUnit::none && unit != columns.sizes.unit)
          source.refuse(cells.rows[i].line,
                        fmt::format("{} names another unit than the column {}: correct one of them",
                                    in_quotes(cell), in_quotes(columns.size_name)));
}

void check_comments(const Cells &cells, const TableColumns &columns, const Source &source) {
  const bool are_retained = columns.values.meaning == ColumnMeaning::retained;
  for (const CellRow &comment : cells.comments) {
    std::vector<MassStatement> statements;
    add_statements(comment, nullptr, statements);
    const bool has_mass = std::any_of(statements.begin(), statements.end(), UnusedColumns::states_mass);
    const bool changes_values =
        std::any_of(comment.cells.begin(), comment.cells.end(), [are_retained](const std::string &cell) {
          return speaks_of_splitting(cell) || (are_retained && states_sums(cell));
        });
    if (has_mass || changes_values)
      source.refuse(
          comment.line,
          fmt::format("the comment {} speaks of the masses in the table: write it without #, or leave "
                      "it out",
                      in_quotes(comment.first())));
  }
}

} // namespace mdm
