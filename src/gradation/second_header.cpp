#include "gradation/second_header.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/unread_columns.hpp"
#include "gradation/unused_columns.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

namespace mdm {

void SecondHeader::check(const HeaderMeaning &values, const WordsOfRows &words, bool has_rows,
                         const ColumnsBeside &beside) const {
  check_values(values);
  check_rows(values.meaning == ColumnMeaning::retained, words, has_rows);
  check_columns(beside);
}

void SecondHeader::check_values(const HeaderMeaning &values) const {
  if (next_.values.meaning != values.meaning || next_.values.unit != values.unit ||
      next_.grams != first_.grams)
    refuse(fmt::format("a second table begins, with {} where the first has {}: leave one of them out",
                       in_quotes(next_.value_name), in_quotes(first_.value_name)));
}

/// What is retained below another heading may be of another sample, or of a part of the first, and so may be
/// a stack that begins with an empty sieve again.
void SecondHeader::check_rows(bool are_retained, const WordsOfRows &words, bool has_rows) const {
  const std::optional<NumberCell> first = next_.first_row < cells_.rows.size()
                                              ? number_cell(cells_.rows[next_.first_row].cell(next_.value))
                                              : std::nullopt;
  if (are_retained && first && is_zero(*first) && has_rows)
    refuse(
        fmt::format("a second table begins with a sieve that retains nothing: it may be of another sample, "
                    "or of a part of the first, which mdm convert {} joins: leave one of them out, or its "
                    "header if it is the same stack",
                    option("split", OptionSpelling::program)));
  const std::string_view between = words.between_tables();
  if (!between.empty() && (are_retained || words.are_of_others()))
    refuse(
        fmt::format("a second table begins below {}: it may be of another sample, or of a part of the first, "
                    "which mdm convert {} joins: leave one of them out, or the words between them",
                    in_quotes(between), option("split", OptionSpelling::program)));
}

/// A column of masses that the first header has not could be compared with a part of the table alone.
void SecondHeader::check_columns(const ColumnsBeside &beside) const {
  const auto refuse_new = [this](const std::string &name) {
    refuse(
        fmt::format("a second table begins, with a column {} that the first has not: write both parts below "
                    "one header, or leave the column out",
                    in_quotes(name)));
  };
  for (const FurtherColumn &column : next_.further)
    if (!beside.have(column))
      refuse_new(column.name);
  for (const UnusedColumn &column : next_.others)
    if ((may_hold_values(column.name) || UnusedColumns::names_mass(column.name)) &&
        !is_among(column, first_.others))
      refuse_new(column.name);
}

} // namespace mdm
