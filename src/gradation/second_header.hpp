#pragma once
/// \file
/// A header below rows of a table: it may go on with them, or begin a table of its own.

#include "gradation/table_columns.hpp"
#include "gradation/value_columns.hpp"
#include "gradation/words_of_rows.hpp"

namespace mdm {

/// Such a header beside that of the rows above it.
class SecondHeader {
public:
  /// \param row  of the second header
  SecondHeader(const Cells &cells, std::size_t row, const TableColumns &first, const TableColumns &next,
               const Source &source)
      : cells_(cells), row_(row), first_(first), next_(next), source_(source) {}

  /// \param values  of the first header, as they are read
  /// \param words   that stand between the two
  /// \param has_rows  false where the first header has none
  /// \param beside  the columns of mass of the first header that are compared
  /// \throws InputError where it may begin another table
  void check(const HeaderMeaning &values, const WordsOfRows &words, bool has_rows,
             const ColumnsBeside &beside) const;

private:
  void check_values(const HeaderMeaning &values) const;
  void check_rows(bool are_retained, const WordsOfRows &words, bool has_rows) const;
  void check_columns(const ColumnsBeside &beside) const;
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(cells_.rows[row_].line, what); }

  const Cells &cells_;
  std::size_t row_;
  const TableColumns &first_, &next_;
  const Source &source_;
};

} // namespace mdm
