#pragma once
/// \file
/// What a sheet says of masses above and below its table: `Dry mass (g),700.00`, `Trockenmasse: 500,0 g`.

#include "gradation/cells.hpp"
#include "gradation/printed_number.hpp"
#include "gradation/row_words.hpp"

namespace mdm {

/// A number beside words.
struct MassStatement {
  RowMeaning meaning;
  std::string label;
  std::string digits;              ///< of its number
  std::string further_digits = {}; ///< of a number right behind it, which may belong to it
  bool is_percent = false;
  bool is_text = false;     ///< of a workbook: a text, not stored as a number
  bool is_sentence = false; ///< the number stands among words, and is not read
  unsigned grams = 0;       ///< in one of its unit; 0 where that is not said
  std::size_t line = 1;
};

/// A statement with its number, in the unit that it is stated in.
struct StatedNumber {
  MassStatement statement;
  PrintedNumber number;
};

/// Adds what a row above or below the table states: a number beside its words, or below them in `next`, or in
/// one cell with them.
void add_statements(const CellRow &row, const CellRow *next, std::vector<MassStatement> &statements);

/// The grams in one of the mass unit that a text names: 1000 of kg; 0 where it names none.
unsigned grams_in(std::string_view text);

/// The number in the digits of a cell.
/// \throws InputError if it is none
PrintedNumber printed_number(std::string_view digits, char decimal_sign);

} // namespace mdm
