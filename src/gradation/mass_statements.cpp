#include "gradation/mass_statements.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/header_words.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/sheet_remarks.hpp"
#include "number/decimal_exponent.hpp"
#include "text/lines.hpp"

#include <mdm/number/decimal.hpp>

#include <algorithm>
#include <tuple>

namespace mdm {
namespace {

/// True for the colon of `10:45`, and not of `Wash loss below 0.063: 4`.
bool is_of_time(std::string_view cell, std::size_t colon) {
  constexpr std::size_t two = 2;
  const std::size_t before = cell.find_last_not_of("0123456789", colon == 0 ? 0 : colon - 1) + 1;
  const std::size_t end = std::min(cell.find_first_not_of("0123456789", colon + 1), cell.size());
  const bool is_decimal = before > 0 && (cell[before - 1] == '.' || cell[before - 1] == ',');
  return before < colon && colon - before <= two && !is_decimal && end - colon - 1 == two;
}

/// The text ahead of a number in one cell with it: `Dry mass: 500 g`, `Dry mass = 500 g`.
std::pair<std::string_view, std::string_view> split_statement(std::string_view cell) {
  const std::size_t sign = cell.find_last_of(":=");
  if (sign == std::string_view::npos || (cell[sign] == ':' && is_of_time(cell, sign)))
    return {cell, {}};
  return {without_spaces(cell.substr(0, sign)), without_spaces(cell.substr(sign + 1))};
}

/// `Wash loss 20 g` of `Remarks: wash loss 20 g`.
std::string_view without_word_of_note(std::string_view cell) {
  const std::size_t colon = cell.find(':');
  const bool is_note = colon != std::string_view::npos && heads_remarks(cell.substr(0, colon));
  return is_note ? without_spaces(cell.substr(colon + 1)) : cell;
}

/// `1` and `234.5 g`: the number may be cut in two between its thousands.
bool are_thousands(std::string_view label, std::string_view behind) {
  constexpr std::size_t thousand = 3;
  const std::size_t digits = std::min(behind.find_first_not_of("0123456789"), behind.size());
  return !label.empty() && is_digit(label.back()) && digits == thousand &&
         (label.size() == 1 || label[label.find_last_not_of("0123456789")] == ' ');
}

/// True for a number that may be the decimals of that in the cell before it, or its thousands.
bool may_go_on(const NumberCell &number) {
  constexpr std::size_t thousand = 3;
  const std::size_t digits = number.digits.find_first_not_of("0123456789");
  return number.unit != ColumnUnit::percent && (digits == std::string_view::npos || digits == thousand);
}

/// The digits of the last whole number in a text. \pre it has a digit
std::string_view last_digits(std::string_view text) {
  const std::size_t last = text.find_last_of("0123456789");
  const std::size_t before = text.find_last_not_of("0123456789", last);
  return text.substr(before + 1, last - before);
}

/// A label and the number with its unit at its end: `Wash loss 70 g`, `Wash loss 14 %`; nothing where it does
/// not end so, as `Dry mass M1 [g]` does.
std::optional<std::pair<std::string_view, std::string_view>> split_at_mass(std::string_view cell) {
  const std::size_t last = cell.find_last_of("0123456789");
  if (last == std::string_view::npos || cell.find_first_of("([{", last) != std::string_view::npos)
    return std::nullopt;
  const ColumnUnit unit = unit_of_words(cell.substr(last + 1));
  if (unit != ColumnUnit::mass && unit != ColumnUnit::percent)
    return std::nullopt;
  const std::size_t before = cell.find_last_not_of("0123456789.,", last);
  if (before == std::string_view::npos || cell[before] != ' ')
    return std::nullopt;
  return std::pair(without_spaces(cell.substr(0, before + 1)), cell.substr(before + 1));
}

/// True for what is weighed once and decides what was lost: its number must not be overlooked.
bool must_be_read(std::string_view label) {
  switch (row_words(label).meaning) {
  case RowMeaning::wash_loss:
  case RowMeaning::pan_and_wash:
  case RowMeaning::initial_mass:
  case RowMeaning::sieved_mass:
  case RowMeaning::washed_mass:
  case RowMeaning::washed_with_container:
  case RowMeaning::sieve_loss:
    return true;
  default:
    return false;
  }
}

/// What may stand between a label and its number: `:`, `Ms`, `M1`, `calc.`.
bool is_symbol(std::string_view cell) {
  constexpr std::size_t longest = 5;
  if (cell == ":" || cell == "=")
    return true;
  const std::size_t letters = static_cast<std::size_t>(
      std::find_if_not(cell.begin(), cell.end(), [](char c) { return lower(c) >= 'a' && lower(c) <= 'z'; }) -
      cell.begin());
  const std::string_view behind = cell.substr(letters);
  return letters > 0 && cell.size() <= longest && unit_of_words(cell) == ColumnUnit::none &&
         !has_word("yes no ja nein oui non si none nil", plain_words(cell)) &&
         (behind.empty() || behind == "." || (letters <= 2 && behind.size() == 1 && is_digit(behind[0])));
}

/// True where a number and a unit of mass stand in the text: `Wash loss 70 g of`.
bool holds_mass(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (is_digit(words[i].front()) && unit_of_words(words[i + 1]) == ColumnUnit::mass)
      return true;
  return false;
}

/// The unit of the first mass or percentage that stands among words: `48.0 g of fines were washed out`; none
/// where there is none.
ColumnUnit unit_of_amount(std::string_view text) {
  for (std::size_t i = 1; i < text.size(); ++i) {
    const std::size_t unit = text.find_first_not_of(' ', i);
    if (!is_digit(text[i - 1]) || is_digit(text[i]) || unit == std::string_view::npos)
      continue;
    const std::size_t end = std::min(text.find_first_of(" ,;:.()[]", unit), text.size());
    const ColumnUnit found = unit_of_words(text.substr(unit, end - unit));
    if (found == ColumnUnit::mass || found == ColumnUnit::percent)
      return found;
  }
  return ColumnUnit::none;
}

/// True for a sentence with an amount that may pass the finest sieve.
bool may_state_fines(std::string_view text) {
  const ColumnUnit unit = unit_of_amount(text);
  return unit != ColumnUnit::none &&
         (speaks_of_washing(text) || (unit == ColumnUnit::mass && may_be_fines(text)));
}

class RowStatements {
public:
  RowStatements(const CellRow &row, const CellRow *next, std::vector<MassStatement> &statements)
      : row_(row), next_(next), statements_(statements) {}

  void add() {
    for (std::size_t i = 0; i < row_.cells.size(); ++i)
      take(i);
    const bool is_open = loose_ && !stated_ && must_be_read(label_);
    const std::string_view label = label_;
    const std::size_t before = statements_.size();
    take_below();
    if (is_open && statements_.size() == before)
      take_loose(label);
  }

private:
  void take(std::size_t i) {
    const std::string_view cell = row_.cell(i);
    if (cell.empty())
      return;
    if (const std::optional<NumberCell> number = number_cell(cell)) {
      if (stated_ && stated_at_ + 1 == i && must_be_read(label_) && may_go_on(*number))
        statements_.back().further_digits = number->digits;
      else if (!label_.empty())
        state(*number, cell, row_, i);
      else if (!loose_)
        loose_ = i;
      return;
    }
    if (stated_ && names_other_mass(cell) && words_of(cell).size() == 1) {
      statements_.back().label += " (" + std::string(cell) + ")";
      return;
    }
    if (unit_of_words(cell) != ColumnUnit::none && !label_.empty()) {
      unit_ = cell;
      if (stated_)
        give_unit(statements_.back());
      return;
    }
    if (!stated_ && must_be_read(label_) && is_symbol(cell))
      return;
    if (!stated_ && must_be_read(label_) && has_digit(cell) && row_words(cell).meaning == RowMeaning::none) {
      state_unclear(label_, cell);
      stated_ = true;
      return;
    }
    take_label(cell, i);
  }

  /// A cell of words, with a number in it or without.
  void take_label(std::string_view whole_cell, std::size_t i) {
    const std::string_view cell = without_word_of_note(whole_cell);
    auto [label, behind] = split_statement(cell);
    if (behind.empty())
      if (const auto parts = split_at_mass(cell))
        std::tie(label, behind) = *parts;
    const bool says_mass = speaks_of_washing(label) || row_words(label).meaning != RowMeaning::none;
    const bool has_two = says_mass && (behind.empty() ? holds_mass(cell) && must_be_read(cell)
                                                      : holds_mass(label) || are_thousands(label, behind));
    const std::optional<NumberCell> number = has_two ? std::nullopt : number_cell(behind);
    // `M1: total dry mass (g)`
    const bool is_numbered = !number && row_words(label).meaning == RowMeaning::none && must_be_read(behind);
    label_ = is_numbered ? behind : label;
    unit_ = {};
    stated_ = false;
    if (has_two) {
      state_unclear(label, cell);
      stated_ = true;
    } else if (number) {
      state(*number, behind, row_, i);
    } else if (!is_numbered && must_be_read(label) && has_digit(behind)) {
      state_unclear(label, behind);
      stated_ = true;
    } else if (may_state_fines(cell)) {
      MassStatement s{RowMeaning::none, std::string(cell), std::string(cell)};
      s.line = row_.line;
      s.is_sentence = true;
      statements_.push_back(std::move(s));
      stated_ = true;
    } else if (speaks_of_splitting(cell) && has_digit(cell)) {
      MassStatement s{RowMeaning::none, std::string(cell), std::string(last_digits(cell))};
      s.line = row_.line;
      statements_.push_back(std::move(s));
      stated_ = true;
    }
  }

  /// `70,wash loss (g)`: the number of a label is before it.
  void take_loose(std::string_view label) {
    label_ = label;
    stated_ = false;
    const std::string_view cell = row_.cell(*loose_);
    state(*number_cell(cell), cell, row_, *loose_);
  }

  /// A number that cannot be told from its text: the text is refused where it is read.
  void state_unclear(std::string_view label, std::string_view text) const {
    MassStatement s{row_words(label).meaning, std::string(label), std::string(text)};
    s.line = row_.line;
    statements_.push_back(std::move(s));
  }

  /// \param text  of the number, in that column of that row
  void state(const NumberCell &number, std::string_view text, const CellRow &row, std::size_t column) {
    const bool is_size = is_of_sizes(unit_in_header(label_)) && number.unit != ColumnUnit::mass &&
                         row_words(label_).meaning == RowMeaning::none;
    if (stated_ || is_of_sizes(number.unit) || is_size)
      return;
    MassStatement s{row_words(label_).meaning, std::string(label_), std::string(number.digits)};
    s.line = row_.line;
    s.grams = grams_in(text.substr(number.digits.size()));
    s.is_percent = number.unit == ColumnUnit::percent;
    s.is_text = std::binary_search(row.texts.begin(), row.texts.end(), column);
    give_unit(s);
    statements_.push_back(std::move(s));
    stated_ = true;
    stated_at_ = column;
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
    if (next_ == nullptr || heads_water_content())
      return;
    for (std::size_t i = 0; i < row_.cells.size(); ++i) {
      const bool is_alone = i + 1 >= row_.cells.size() || !number_cell(row_.cell(i + 1));
      const std::optional<NumberCell> number = number_cell(next_->cell(i));
      const bool is_of_mass = row_words(row_.cell(i)).meaning != RowMeaning::none ||
                              unit_in_header(row_.cell(i)) == ColumnUnit::mass;
      if (!is_alone || !number || number_cell(row_.cell(i)) || !is_of_mass)
        continue;
      label_ = row_.cell(i);
      unit_ = {};
      stated_ = false;
      state(*number, next_->cell(i), *next_, i);
    }
  }

  /// `Container,Wet mass (g),Dry mass (g)`: the masses below are of what was dried for its water content.
  bool heads_water_content() const {
    bool has_moist = false, has_dry = false, has_container = false;
    for (const std::string &cell : row_.cells) {
      if (speaks_of_washing(cell) || may_be_fines(cell))
        return false;
      const RowMeaning meaning = row_words(cell).meaning;
      has_moist |= meaning == RowMeaning::moist_mass;
      has_dry |= meaning == RowMeaning::initial_mass;
      has_container |= !has_moist && speaks_of_moisture_or_container(cell);
    }
    return has_moist && has_dry && has_container;
  }

  const CellRow &row_;
  const CellRow *next_;
  std::vector<MassStatement> &statements_;
  std::string_view label_, unit_;
  bool stated_ = false;              ///< the label has its number
  std::size_t stated_at_ = 0;        ///< its column
  std::optional<std::size_t> loose_; ///< column of the first number without a label before it
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
