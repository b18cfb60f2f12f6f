#include "gradation/mass_statements.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/header_words.hpp"
#include "gradation/plain_words.hpp"
#include "number/decimal_exponent.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// The text ahead of a number in one cell with it: `Dry mass: 500 g`, `Dry mass = 500 g`.
std::pair<std::string_view, std::string_view> split_statement(std::string_view cell) {
  const std::size_t sign = cell.find_last_of(":=");
  if (sign == std::string_view::npos)
    return {cell, {}};
  return {without_spaces(cell.substr(0, sign)), without_spaces(cell.substr(sign + 1))};
}

class RowStatements {
public:
  RowStatements(const CellRow &row, const CellRow *next, std::vector<MassStatement> &statements)
      : row_(row), next_(next), statements_(statements) {}

  void add() {
    for (std::size_t i = 0; i < row_.cells.size(); ++i)
      take(i);
    take_below();
  }

private:
  void take(std::size_t i) {
    const std::string_view cell = row_.cell(i);
    if (cell.empty())
      return;
    if (const std::optional<NumberCell> number = number_cell(cell)) {
      if (!label_.empty())
        state(*number, cell, row_, i);
      return;
    }
    if (unit_of_words(cell) != ColumnUnit::none && !label_.empty()) {
      unit_ = cell;
      if (stated_)
        give_unit(statements_.back());
      return;
    }
    const auto [label, behind] = split_statement(cell);
    label_ = label;
    unit_ = {};
    stated_ = false;
    if (const std::optional<NumberCell> number = number_cell(behind))
      state(*number, behind, row_, i);
  }

  /// \param text  of the number, in that column of that row
  void state(const NumberCell &number, std::string_view text, const CellRow &row, std::size_t column) {
    if (stated_ || is_of_sizes(number.unit) || is_of_sizes(unit_in_header(label_)))
      return;
    MassStatement s{row_words(label_).meaning, std::string(label_), std::string(number.digits)};
    s.line = row_.line;
    s.grams = grams_in(text.substr(number.digits.size()));
    s.is_percent = number.unit == ColumnUnit::percent;
    s.is_text = std::binary_search(row.texts.begin(), row.texts.end(), column);
    give_unit(s);
    statements_.push_back(std::move(s));
    stated_ = true;
  }

  void give_unit(MassStatement &s) const {
    for (const std::string_view text : {unit_, std::string_view(s.label)})
      if (s.grams == 0)
        s.grams = grams_in(text);
    s.is_percent |=
        unit_of_words(unit_) == ColumnUnit::percent || unit_in_header(s.label) == ColumnUnit::percent;
  }

  /// A label alone whose number is in the row below.
  void take_below() {
    if (next_ == nullptr)
      return;
    for (std::size_t i = 0; i < row_.cells.size(); ++i) {
      const bool is_alone = i + 1 >= row_.cells.size() || !number_cell(row_.cell(i + 1));
      const std::optional<NumberCell> number = number_cell(next_->cell(i));
      if (!is_alone || !number || number_cell(row_.cell(i)) ||
          row_words(row_.cell(i)).meaning == RowMeaning::none)
        continue;
      label_ = row_.cell(i);
      unit_ = {};
      stated_ = false;
      state(*number, next_->cell(i), *next_, i);
    }
  }

  const CellRow &row_;
  const CellRow *next_;
  std::vector<MassStatement> &statements_;
  std::string_view label_, unit_;
  bool stated_ = false; ///< the label has its number
};

} // namespace

unsigned grams_in(std::string_view text) {
  if (names_kilograms(text))
    return 1000;
  const std::vector<std::string> words = words_of(text);
  return std::any_of(words.begin(), words.end(),
                     [](const std::string &word) { return unit_of_words(word) == ColumnUnit::mass; });
}

PrintedNumber printed_number(std::string_view digits, char decimal_sign) {
  const Rational value = parse_decimal(digits, decimal_sign);
  Rational half = last_digit_unit(digits, decimal_sign) / 2;
  // Numbers of so many digits come from floating point: their last digits are errors of sums and quotients.
  constexpr std::ptrdiff_t floating = 12;
  if (std::count_if(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) > floating)
    half = std::max<Rational>(half, ten_to(-11) * std::max<Rational>(abs(value), 1));
  return {value, half};
}

void add_statements(const CellRow &row, const CellRow *next, std::vector<MassStatement> &statements) {
  RowStatements(row, next, statements).add();
}

} // namespace mdm
