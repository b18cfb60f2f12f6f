#include "gradation/lab_rows.hpp"

#include "gradation/cell_numbers.hpp"
#include "gradation/decimal_commas.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_sizes.hpp"
#include "gradation/second_header.hpp"
#include "gradation/sheet_remarks.hpp"
#include "gradation/sieve_order.hpp"
#include "gradation/stated_numbers.hpp"
#include "gradation/unused_columns.hpp"
#include "gradation/words_of_rows.hpp"
#include "text/lines.hpp"
#include "text/option_name.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <numeric>

namespace mdm {
namespace {

std::size_t header_line(const Cells &cells, const TableColumns &columns) {
  if (cells.rows.empty())
    return 1;
  const std::size_t row = columns.first_row == 0 ? 0 : columns.first_row - 1;
  return cells.rows[std::min(row, cells.rows.size() - 1)].line;
}

TableSign sign_of(const Cells &cells, const TableColumns &columns,
                  const std::vector<MassStatement> &statements, const Source &source) {
  try {
    return table_sign(cells, columns, statements);
  } catch (const InputError &error) {
    source.refuse(header_line(cells, columns), error.what());
  }
}

/// `0.063 mm`, `#200 wet`, `No. 4`: what stands behind such a beginning is said of a sieve.
bool begins_with_sieve(std::string_view cell) {
  return !cell.empty() &&
         (is_digit(cell.front()) || cell.front() == '#' || plain_words(cell).starts_with("no "));
}

bool has_number(const CellRow &row) {
  return std::any_of(row.cells.begin(), row.cells.end(),
                     [](const std::string &cell) { return number_cell(cell).has_value(); });
}

/// True for what has a row in the table; other masses stand beside it.
bool belongs_to_table(RowMeaning meaning) {
  return meaning == RowMeaning::pan || meaning == RowMeaning::wash_loss ||
         meaning == RowMeaning::pan_and_wash || meaning == RowMeaning::passing ||
         meaning == RowMeaning::total || meaning == RowMeaning::sieve_loss;
}

/// A pass over the rows below the header.
class RowPass {
public:
  RowPass(const Cells &cells, TableColumns columns, const Reading &reading, const Source &source)
      : cells_(cells), columns_(std::move(columns)), reading_(reading), source_(source),
        statements_(statements_above(cells_, columns_)),
        sign_(sign_of(cells_, columns_, statements_, source)), sizes_(cells_, columns_, reading, sign_),
        chosen_(columns_.value_name, columns_.values, columns_.grams, sign_),
        beside_(columns_.further, sign_), unused_(columns_, reading.columns.has_value(), sign_, source) {
    read_.table.unit = sizes_.unit();
    read_.table.file_unit = sizes_.file_unit();
    read_.table.header_line = header_line(cells_, columns_);
  }

  LabRows run() {
    for (row_ = columns_.first_row; row_ < cells_.rows.size(); ++row_)
      read_row();
    if (read_.table.sizes.empty())
      source_.refuse(read_.table.header_line,
                     fmt::format("there is no row with a size and a number below {} and {}: {}",
                                 in_quotes(columns_.size_name), in_quotes(columns_.value_name),
                                 column_options()));
    if (const std::optional<std::size_t> row = out_of_order(read_.table.sizes))
      read_.out_of_order = read_.table.lines[*row];
    unused_.check_samples(sieves_, chosen_.meaning().meaning);
    if (cells_.delimiter == ',' && !reading_.columns)
      check_last_column(sieves_, columns_, source_);
    unused_.check_corrected(read_.table, sieves_,
                            chosen_.meaning().meaning); // ranges have no row of their top yet
    sizes_.settle(read_.table, chosen_.meaning().meaning == ColumnMeaning::retained, source_);
    read_.stated = stated_numbers(statements_, sign_, read_.table.header_line, read_.left, source_);
    for (const StatedNumber &number : read_.stated)
      check_washing_sieve(number.statement);
    read_.beside = beside_.all();
    read_.errors = beside_.errors();
    read_.unread = unused_.speaking_of_mass(sieves_);
    columns_.values = chosen_.meaning();
    columns_.others = unused_.all();
    read_.columns = columns_;
    return std::move(read_);
  }

private:
  const CellRow &row() const { return cells_.rows[row_]; }
  std::string_view size_cell() const { return row().cell(columns_.size); }
  std::string_view value_cell() const { return row().cell(columns_.value); }
  [[noreturn]] void refuse(const std::string &what) const { source_.refuse(row().line, what); }
  void leave() { read_.left.add(row().first()); }

  /// What is wrong with a cell is wrong in its line.
  template <typename Action>
  auto in_line(Action action) const {
    return in_line(row().line, action);
  }
  template <typename Action>
  auto in_line(std::size_t line, Action action) const {
    try {
      return action();
    } catch (const InputError &error) {
      source_.refuse(line, error.what());
    }
  }

  bool has_number_beside() const {
    return in_line([this] { return beside_.have_number(row()); });
  }

  void read_row() {
    below_gap_ |= row().below_gap && !read_.table.sizes.empty();
    check_words_of_splitting();
    if (take_second_header() || take_account())
      return;
    const bool lacks_value = value_cell().empty() && number_cell(size_cell());
    if (lacks_value && take_words_below())
      return;
    if (lacks_value)
      return read_unvalued();
    if (!take_text())
      read_sieve();
  }

  /// A part of the sample that was sieved for the whole must not be added to the rest.
  void check_words_of_splitting() const {
    for (const std::string &cell : row().cells)
      if (speaks_of_splitting(cell) && (!below_gap_ || has_number(row())))
        refuse(fmt::format("{} may be of a part of the sample that was sieved for the whole: write the two "
                           "into files of their own for mdm convert {}, give percent passing of the whole, "
                           "or leave the words out",
                           in_quotes(cell), option("split", OptionSpelling::program)));
  }

  // ---- another header

  /// A header of the same kind below, such as that of a hydrometer's rows.
  bool take_second_header() {
    if (number_cell(value_cell()) || size_cell().empty())
      return false;
    const std::optional<TableColumns> next = columns_of_row(cells_, row_, further_reading(), source_);
    if (!next || reading_.columns)
      return false;
    SecondHeader(cells_, row_, columns_, *next, source_)
        .check(chosen_.meaning(), words_, !read_.table.sizes.empty(), beside_);
    read_.further_headers.push_back(row().line);
    if (const std::vector<Rational> &sizes = read_.table.sizes; !sizes.empty()) {
      const auto [least, largest] = std::minmax_element(sizes.begin(), sizes.end());
      above_header_ = Interval(*least, *largest);
    }
    columns_.size = next->size;
    columns_.value = next->value;
    columns_.names = next->names;
    columns_.others = next->others;
    unused_.go_on(next->others);
    if (next->sizes.unit != columns_.sizes.unit)
      sizes_.begin_unit();
    columns_.sizes = next->sizes;
    columns_.width = next->width;
    beside_.go_on(next->further);
    row_ = next->first_row - 1;
    below_gap_ = false;
    words_ = WordsOfRows();
    return true;
  }

  /// The unit that was asked for is that of the first header.
  Reading further_reading() const {
    Reading reading = reading_;
    if (!read_.table.sizes.empty())
      reading.unit.reset();
    return reading;
  }

  // ---- pan, losses, sums

  /// A row of the pan, of wash loss, of a sum, or what is said of the sample below the table.
  bool take_account() {
    const RowWords known = words();
    if (known.meaning == RowMeaning::none)
      return false;
    const bool are_retained = chosen_.meaning().meaning == ColumnMeaning::retained;
    const bool may_lack_value = value_cell().empty() && (!are_retained || known.meaning == RowMeaning::total);
    if (belongs_to_table(known.meaning) &&
        (number_cell(value_cell()) || (may_lack_value && has_number_beside()))) {
      add_account(known);
      return true;
    }
    if (known.meaning == RowMeaning::container && are_retained && number_cell(value_cell()) &&
        (!below_gap_ || !speaks_of_mass(row().first())))
      refuse(fmt::format("{} may be the pan, or a container that was weighed: write Pan for what passed the "
                         "finest sieve, else leave the row out",
                         in_quotes(row().first())));
    if (known.meaning == RowMeaning::moist_mass && !below_gap_ && number_cell(value_cell()) &&
        !speaks_of_mass(row().first()))
      refuse(fmt::format(
          "{} may be a row of the table, or a moist mass: write the sieve, Pan or Wash loss, or Moist mass",
          in_quotes(row().first())));
    if (known.meaning == RowMeaning::pan && !below_gap_ && are_retained)
      in_line([this] { chosen_.refuse(value_cell()); });
    const std::size_t before = statements_.size();
    add_statements(row(), nullptr, statements_);
    if (belongs_to_table(known.meaning) && known.meaning != RowMeaning::total && !below_gap_ &&
        statements_.size() > before && has_number_beside())
      refuse(fmt::format("the row {} has no value in the column {}: write it, or 0", in_quotes(row().first()),
                         in_quotes(columns_.value_name)));
    if (known.meaning == RowMeaning::passing && below_gap_)
      words_.add_below(row());
    else if (known.meaning == RowMeaning::passing && statements_.size() == before &&
             !read_.table.sizes.empty())
      words_.add_among(row());
    if (statements_.size() == before || known.meaning == RowMeaning::moist_mass)
      leave();
    return true;
  }

  /// The words of a row that is no sieve: those of its first cell, or of the cell of its size.
  RowWords words() const {
    for (const std::string_view cell : {row().first(), size_cell()})
      if (!begins_with_sieve(cell))
        if (const RowWords known = row_words(cell); known.meaning != RowMeaning::none)
          return is_beside_sieve(known, cell) ? RowWords{} : known;
    return {};
  }

  /// True for words that are a remark, as they stand beside a sieve: `wet,0.063,50`.
  bool is_beside_sieve(const RowWords &known, std::string_view cell) const {
    const std::optional<NumberCell> size = number_cell(size_cell());
    if (!size || is_zero(*size) || cell == size_cell() || !known.sieve.empty())
      return false;
    if (belongs_to_table(known.meaning) && may_be_remark(cell) && number_cell(value_cell()))
      refuse(fmt::format("{} is beside the size {}: leave the size out if it is no sieve, else the word",
                         in_quotes(cell), in_quotes(size_cell())));
    return !belongs_to_table(known.meaning);
  }

  void add_account(const RowWords &known) {
    words_.check_among(source_);
    check_width();
    unused_.check_unit(row());
    unused_.check_account(row(), sieves_);
    check_words_beside();
    check_mass_unit();
    AccountRow account{known.meaning, 0, false, std::string(row().first()), row().line, {}};
    in_line([&] {
      if (!known.sieve.empty()) {
        account.size = sizes_.named(known.sieve);
        account.names_sieve = true;
      }
      account.numbers.push_back(value_cell().empty() ? std::nullopt
                                                     : std::optional(chosen_.read(value_cell())));
      for (std::optional<PrintedNumber> &number : beside_.numbers(row()))
        account.numbers.push_back(std::move(number));
    });
    read_.accounts.push_back(std::move(account));
    note_hidden();
  }

  /// A label may name another unit of mass than the column.
  void check_mass_unit() const {
    const unsigned here = grams_in(row().first());
    const bool is_mass =
        chosen_.meaning().unit == ColumnUnit::mass || chosen_.meaning().unit == ColumnUnit::none;
    const bool is_other =
        names_other_mass(row().first()) || (here != 0 && here != std::max(columns_.grams, 1U));
    if (is_mass && is_other)
      refuse(fmt::format("{} is in another unit of mass than the column {}: write all alike",
                         in_quotes(row().first()), in_quotes(columns_.value_name)));
    if (is_mass && unit_in_header(row().first()) == ColumnUnit::percent)
      refuse(fmt::format("{} is a percentage, and the column {} has masses: write the mass",
                         in_quotes(row().first()), in_quotes(columns_.value_name)));
  }

  void note_hidden() {
    if (row().is_hidden)
      read_.hidden.add(row().first());
  }

  // ---- words

  /// A size without a value.
  void read_unvalued() const {
    const bool is_retained = chosen_.meaning().meaning == ColumnMeaning::retained;
    refuse(fmt::format("the size {} has no value in the column {}: write {}or leave the row out",
                       in_quotes(size_cell()), in_quotes(columns_.value_name),
                       is_retained ? "0 where nothing was retained, " : "it, "));
  }

  /// `Gs,2.65,` below the pan, a sum or an empty row: the number is that of the words, which name no sieve.
  bool take_words_below() {
    const std::string_view words = row().first();
    const bool is_below = below_gap_ || !read_.accounts.empty();
    if (!is_below || number_cell(words) || begins_with_sieve(words) || sizes_.may_be_size(words) ||
        row_words(words).meaning != RowMeaning::none || may_be_fines(words) || speaks_of_washing(words) ||
        has_number_beside())
      return false;
    words_.add_below(row());
    leave();
    return true;
  }

  /// A row that is none of the curve: words without a value, or anything below an empty row that has no size.
  bool take_text() {
    const bool is_size = sizes_.may_be_size(size_cell());
    if (is_size && number_cell(value_cell()))
      return false;
    if (!below_gap_ ? is_size || !value_cell().empty() : sizes_.is_size(size_cell()) && !value_cell().empty())
      return false;
    if (!below_gap_ && has_number_beside() && !names_index(row().first()))
      refuse(
          fmt::format("the row {} has numbers and no value in the column {}: write it, or leave the row out",
                      in_quotes(row().first()), in_quotes(columns_.value_name)));
    if (below_gap_ && is_row_beside())
      refuse(fmt::format(
          "{} begins a row beside the columns {} and {}: write all rows of the table below each other",
          in_quotes(row().first()), in_quotes(columns_.size_name), in_quotes(columns_.value_name)));
    if (below_gap_ && number_cell(value_cell()) && !is_remark_with_number())
      refuse(fmt::format(
          "{} has {} in the column {}, and may be a sieve or what passed the finest one: write the "
          "sieve's size or Pan, else leave the row out",
          in_quotes(first_words()), in_quotes(value_cell()), in_quotes(columns_.value_name)));
    check_shares_of_part();
    add_statements(row(), nullptr, statements_);
    if (below_gap_ || (!read_.table.sizes.empty() && names_sample(row().first())))
      words_.add_below(row());
    else if (!read_.table.sizes.empty())
      words_.add_among(row());
    leave();
    return true;
  }

  /// Words below two tables that were joined may say of what part the shares in one of them are.
  void check_shares_of_part() const {
    if (read_.further_headers.empty() || chosen_.meaning().meaning == ColumnMeaning::retained)
      return;
    for (const std::string &cell : row().cells)
      if (speaks_of_part(cell) &&
          has_any_word("percent percentage percentages shares prozent prozente anteile "
                       "pourcentages porcentajes percentuali",
                       words_of(cell)) &&
          has_any_word("of von der des de du del della", words_of(cell)))
        refuse(fmt::format("{} may say that one of the two tables above has shares of a part: give percent "
                           "passing of the whole, or leave the words out",
                           in_quotes(cell)));
  }

  /// A row below the table whose number is none of a mass or of a sieve.
  bool is_remark_with_number() const {
    const std::string_view label = first_words();
    if (names_index(label) || names_remark(label) || is_sum_alone())
      return true;
    if (label.empty() ||
        std::any_of(label.begin(), label.end(), [](char c) { return is_digit(c) || c == '#'; }))
      return false;
    const std::vector<std::string> words = words_of(label);
    const bool is_percent = std::find(words.begin(), words.end(), "percent") != words.end();
    return chosen_.meaning().meaning == ColumnMeaning::passing || (is_percent && has_pan());
  }

  /// The row's first cell that is no number; empty if it has none.
  std::string_view first_words() const {
    const std::vector<std::string> &cells = row().cells;
    const auto found = std::find_if(cells.begin(), cells.end(),
                                    [](const std::string &c) { return !c.empty() && !number_cell(c); });
    return found == cells.end() ? std::string_view() : std::string_view(*found);
  }

  bool has_pan() const {
    return std::any_of(read_.accounts.begin(), read_.accounts.end(), [](const AccountRow &account) {
      return account.meaning == RowMeaning::pan || account.meaning == RowMeaning::pan_and_wash;
    });
  }

  /// The sum of all rows without a label.
  bool is_sum_alone() const {
    if (row().filled() != 1)
      return false;
    Rational sum = std::accumulate(read_.table.values.begin(), read_.table.values.end(), Rational(0));
    for (const AccountRow &account : read_.accounts)
      if (account.meaning != RowMeaning::total && account.numbers.front())
        sum += account.numbers.front()->value;
    const NumberCell number = *number_cell(value_cell());
    return in_line([&] { return printed_number(number.digits, sign_.in(number.digits)).value; }) == sum;
  }

  /// `,,,0.5,120`: a row of another table, beside the columns of this one.
  bool is_row_beside() const {
    const std::vector<std::string> &cells = row().cells;
    const auto first =
        std::find_if(cells.begin(), cells.end(), [](const std::string &c) { return !c.empty(); });
    return sizes_.is_size(*first) && size_cell().empty() && value_cell().empty() &&
           std::any_of(first + 1, cells.end(),
                       [](const std::string &c) { return number_cell(c).has_value(); });
  }

  /// What was washed through a coarser sieve than the finest need not pass that.
  void check_washing_sieve(const MassStatement &s) const {
    const std::string sieve = row_words(s.label).sieve;
    if ((s.meaning != RowMeaning::wash_loss && s.meaning != RowMeaning::pan_and_wash) || sieve.empty())
      return;
    const auto is_sieve = [](const Rational &size) { return size > 0; };
    std::vector<Rational> sieves;
    std::copy_if(read_.table.sizes.begin(), read_.table.sizes.end(), std::back_inserter(sieves), is_sieve);
    const Rational washed = in_line(s.line, [&] { return sizes_.named(sieve); });
    if (!sieves.empty() && washed > *std::min_element(sieves.begin(), sieves.end()))
      source_.refuse(
          s.line,
          fmt::format(
              "{} is of a sieve that is coarser than the finest one: write it into the row of the sieve "
              "below which it belongs",
              in_quotes(s.label)));
  }

  // ---- sieves

  void read_sieve() {
    Table &table = read_.table;
    if (table.sizes.size() == max_gradation_rows)
      refuse(fmt::format("there are more than {} rows: give fewer sieves", max_gradation_rows));
    words_.check_sieve(row(), size_cell(), source_);
    words_.check_among(source_);
    check_width();
    unused_.check_sieve(row(), read_.table.sizes.size(), beside_.all().empty());
    check_statements_beside();
    unused_.check_unit(row());
    if (cells_.delimiter == ',')
      check_commas(row(), columns_, source_);
    in_line([&] {
      table.sizes.push_back(sizes_.next(row()));
      const PrintedNumber value = chosen_.read(value_cell());
      table.values.push_back(value.value);
      table.roundings.push_back(value.half);
      beside_.take(row());
    });
    check_second_table(table.sizes.back());
    table.lines.push_back(row().line);
    sieves_.push_back(&row());
    note_hidden();
    for (const std::size_t column : {columns_.size, columns_.value})
      if (std::binary_search(row().long_numbers.begin(), row().long_numbers.end(), column))
        read_.long_numbers.add(row().cell(column));
  }

  /// Sieves of one curve go on below a second header: those among the sieves above it are of another table.
  void check_second_table(const Rational &size) const {
    if (above_header_ && above_header_->lo <= size && size <= above_header_->hi)
      refuse(fmt::format("the sieve {} of the second table is among those of the first: it may be of another "
                         "sample, or of a specification: leave one of the two out",
                         in_quotes(size_cell())));
  }

  /// A cell beyond the header is of no column: the row may be split in wrong places.
  void check_width() const {
    const std::vector<std::string> &cells = row().cells;
    for (std::size_t i = columns_.width; columns_.width != 0 && i < cells.size(); ++i)
      if (!cells[i].empty())
        refuse(fmt::format(
            "the row has more cells than the header, {}: {} is beyond: name its column, or put ; between "
            "cells where numbers have decimal commas",
            columns_.width, in_quotes(cells[i])));
  }

  [[noreturn]] void refuse_beside(std::string_view words, std::string_view label) const {
    refuse(fmt::format("{} is beside the row {} and is not read: write it above or below the table",
                       in_quotes(words), in_quotes(label)));
  }

  /// What is said of the sample beside a row of the pan or a sum must not be overlooked.
  void check_words_beside() const {
    if (reading_.columns)
      return;
    bool is_label = true;
    for (const std::string &cell : beside_columns(row(), columns_).cells) {
      if (!is_label && UnusedColumns::names_mass(cell))
        refuse_beside(cell, row().first());
      is_label = is_label && cell.empty() && size_cell().empty();
    }
  }

  /// The same beside a sieve, where a number stands behind the words or among them.
  void check_statements_beside() const {
    if (reading_.columns)
      return;
    const CellRow beside = beside_columns(row(), columns_);
    for (std::size_t i = 0; i < beside.cells.size(); ++i) {
      if (beside.cells[i].empty() || number_cell(beside.cells[i]))
        continue;
      std::vector<MassStatement> statements;
      add_statements({row().line, false, {beside.cells[i], std::string(beside.cell(i + 1))}}, nullptr,
                     statements);
      for (const MassStatement &s : statements)
        if (UnusedColumns::states_mass(s))
          refuse_beside(s.label, size_cell());
    }
  }

  const Cells &cells_;
  TableColumns columns_; ///< of the header above the present row
  const Reading &reading_;
  const Source &source_;
  std::vector<MassStatement> statements_;
  TableSign sign_;
  RowSizes sizes_;
  ChosenColumn chosen_;
  ColumnsBeside beside_;
  UnusedColumns unused_;
  LabRows read_;
  std::size_t row_ = 0;
  bool below_gap_ = false;
  WordsOfRows words_;
  std::vector<const CellRow *> sieves_;
  std::optional<Interval> above_header_; ///< the sizes above the last header; nothing of the first
};

} // namespace

LabRows read_lab_rows(const Cells &cells, TableColumns columns, const Reading &reading,
                      const Source &source) {
  return RowPass(cells, std::move(columns), reading, source).run();
}

} // namespace mdm
