#include "gradation/sheet_accounts.hpp"

#include "gradation/shown.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

/// Fills the columns.
class ColumnFiller {
public:
  ColumnFiller(OrderedAccounts &accounts, const Source &source, std::vector<std::string> &notes)
      : a_(accounts), rows_(accounts.rows), source_(source), notes_(notes) {}

  void fill_all() {
    for (std::size_t c = 0; c < a_.columns.size(); ++c)
      fill(c);
    settle_unclear();
    for (std::size_t i = 0; i < a_.unread.size(); ++i)
      a_.unread[i].sieves = numbers_of_sieves(a_.columns.size() + i);
  }

private:
  void fill(std::size_t c) {
    AccountColumn &here = a_.columns[c];
    here.sieves = numbers_of_sieves(c);
    if (here.is_retained())
      here.below = sum_of_rows(c);
    else if (here.meaning.meaning == ColumnMeaning::cumulative)
      here.below = rest_of_cumulative(c);
    else
      here.below = passing_below(c);
    if (here.adds_masses())
      add_stated_wash(c);
  }

  std::vector<std::optional<PrintedNumber>> numbers_of_sieves(std::size_t c) const {
    std::vector<std::optional<PrintedNumber>> numbers;
    for (const AccountRow &sieve : rows_.sieves)
      numbers.push_back(sieve.numbers[c]);
    return numbers;
  }

  /// What is retained by each sieve, or by all coarser ones too, is what agrees with the chosen column.
  void settle_unclear() {
    for (std::size_t c = 1; c < a_.columns.size(); ++c)
      if (a_.columns[c].meaning.is_unclear && compare(a_.columns[0], a_.columns[c]).disagreement) {
        a_.columns[c].meaning.meaning = ColumnMeaning::cumulative;
        fill(c);
      }
  }

  /// Pan and wash loss; a row of both is not added to them.
  std::optional<PrintedNumber> sum_of_rows(std::size_t c) const {
    const AccountRow *pan_row = rows_.pan(), *wash_row = rows_.wash(), *all_row = rows_.all_fines();
    const std::optional<PrintedNumber> pan = number_of(pan_row, c), wash = number_of(wash_row, c),
                                       all = number_of(all_row, c);
    if (!all) {
      if (pan && wash)
        return *pan + *wash;
      return pan ? pan : wash;
    }
    if (pan && wash && !agree(*all, *pan + *wash))
      source_.refuse(all_row->line,
                     fmt::format("{} is {}, and {} and {} add up to {}: correct one of them",
                                 in_quotes(all_row->label), shown(all->value), in_quotes(pan_row->label),
                                 in_quotes(wash_row->label), shown(Rational(pan->value + wash->value))));
    if (pan && !wash)
      check_part(*pan_row, *pan, *all);
    if (wash && !pan)
      check_part(*wash_row, *wash, *all);
    return all;
  }

  /// Of one row of all that passes and one of a part the first must say that it has the second.
  void check_part(const AccountRow &row, const PrintedNumber &part, const PrintedNumber &all) const {
    const AccountRow &all_row = *rows_.all_fines();
    const bool is_unclear = all_row.meaning == RowMeaning::passing || !joins_parts(all_row.label);
    if (part.range().lo > all.range().hi || (is_unclear && !agree(part, all)))
      refuse_unclear(all_row, row.label);
  }

  /// What passes the finest sieve in one row, and may have a part of it or not.
  [[noreturn]] void refuse_unclear(const AccountRow &all, const std::string &part) const {
    source_.refuse(all.line, fmt::format("{} may have {} in it, or not: write 'Pan + wash' for both, or the "
                                         "rows 'Pan' and 'Wash loss'",
                                         in_quotes(all.label), in_quotes(part)));
  }

  /// What is behind the finest sieve in a column that adds up, whose rows of pan and wash loss go on adding.
  std::optional<PrintedNumber> rest_of_cumulative(std::size_t c) const {
    const std::optional<PrintedNumber> above = finest(c);
    std::optional<PrintedNumber> last = above;
    bool has_row = false;
    for (const AccountRow &row : rows_.others) {
      if (!is_below_sieves(row) || !row.numbers[c])
        continue;
      if (last && row.numbers[c]->range().hi < last->range().lo)
        source_.refuse(
            row.line,
            fmt::format("{} has {} in the column {}, which is cumulative and has {} before: write the "
                        "sum with all that is coarser",
                        in_quotes(row.label), shown(row.numbers[c]->value), in_quotes(a_.columns[c].header),
                        shown(last->value)));
      last = row.numbers[c];
      has_row = true;
    }
    if (a_.columns[c].is_share()) {
      if (has_row)
        check_end(c, *last);
      return above ? std::optional(PrintedNumber{100, 0} - *above) : std::nullopt;
    }
    return has_row && above ? std::optional(*last - *above) : std::nullopt;
  }

  /// The last row of a cumulative share is the whole.
  void check_end(std::size_t c, const PrintedNumber &last) const {
    if (!a_.is_asked && !a_.loss.explains(last, {100, 0}, 100))
      source_.refuse(a_.header_line,
                     fmt::format("the column {} is cumulative and ends at {} percent: correct "
                                 "it, or leave the column out",
                                 in_quotes(a_.columns[c].header), shown(last.value)));
  }

  static bool is_below_sieves(const AccountRow &row) {
    return row.meaning != RowMeaning::total && row.meaning != RowMeaning::sieve_loss;
  }

  std::optional<PrintedNumber> finest(std::size_t c) const {
    return rows_.sieves.empty() ? std::nullopt : rows_.sieves.back().numbers[c];
  }

  /// Nothing passes the pan; a row of what passes the finest sieve may say it again.
  std::optional<PrintedNumber> passing_below(std::size_t c) const {
    const std::optional<PrintedNumber> last = finest(c);
    for (const AccountRow *row : {rows_.pan(), rows_.wash(), rows_.all_fines()})
      if (const std::optional<PrintedNumber> n = number_of(row, c);
          n && n->value != 0 && !(last && agree(*n, *last)))
        source_.refuse(row->line,
                       fmt::format("{} has {} in the column {}, but nothing passes the pan: write 0",
                                   in_quotes(row->label), shown(n->value), in_quotes(a_.columns[c].header)));
    return last;
  }

  /// What was washed out passes the finest sieve too, unless the row of the pan has it already.
  void add_stated_wash(std::size_t c) {
    AccountColumn &here = a_.columns[c];
    const std::optional<StatedMass> &stated = a_.stated.wash_loss;
    const std::optional<PrintedNumber> wash = in_unit_of(here, stated);
    if (!wash)
      return check_percent_of_wash();
    if (const std::optional<PrintedNumber> row = number_of(rows_.wash(), c); row && here.is_retained()) {
      if (!agree(*row, *wash))
        source_.refuse(rows_.wash()->line,
                       fmt::format("{} is {}, and {} in line {} says {}: correct one of "
                                   "them",
                                   in_quotes(rows_.wash()->label), shown(row->value),
                                   in_quotes(stated->label), stated->line, shown(wash->value)));
      return;
    }
    const AccountRow *const all = rows_.all_fines();
    if (rows_.wash() != nullptr || (all != nullptr && all->meaning != RowMeaning::passing))
      return;
    if (here.below) {
      const WashIn place = place_of_wash(here, *wash);
      if (place == WashIn::pan)
        return notes_.push_back(
            fmt::format("The wash loss {} is in the row of the pan: so the masses add up to {}.",
                        shown(wash->value), shown(in_unit_of(here, a_.stated.initial)->value)));
      if (place == WashIn::either)
        check_unclear(here, *wash);
    }
    a_.has_added_wash = true;
    here.below = here.below ? *here.below + *wash : *wash;
  }

  void check_percent_of_wash() const {
    const std::optional<StatedMass> &percent = a_.stated.wash_percent;
    if (percent && !rows_.have_wash() && !a_.stated.initial)
      source_.refuse(percent->line,
                     fmt::format("{} is a percentage of a mass that is not given: write a row 'Wash loss' "
                                 "with the mass",
                                 in_quotes(percent->label)));
  }

  /// Where the sheet adds up: with the wash loss in the row of what passes the finest sieve, or apart.
  enum class WashIn { pan, apart, either };

  WashIn place_of_wash(const AccountColumn &column, const PrintedNumber &wash) const {
    const std::optional<PrintedNumber> rows = column.whole(), initial = in_unit_of(column, a_.stated.initial),
                                       washed = in_unit_of(column, a_.stated.washed);
    // Rounding of many rows may be more than the wash loss.
    const auto is_near = [&wash](const PrintedNumber &a, const PrintedNumber &b) {
      return 4 * abs(Rational(a.value - b.value)) <= wash.value;
    };
    if (column.below->range().hi < wash.range().lo || (rows && washed && is_near(*rows, *washed)))
      return WashIn::apart;
    if (!rows || !initial)
      return WashIn::either;
    const PrintedNumber with = *rows + wash;
    if (is_near(with, *initial) || is_near(*rows, *initial))
      return is_near(with, *initial) ? WashIn::apart : WashIn::pan;
    if (agree(with, *initial) != agree(*rows, *initial))
      return agree(with, *initial) ? WashIn::apart : WashIn::pan;
    if (a_.loss.explains(with, *initial) == a_.loss.explains(*rows, *initial))
      return a_.loss.explains(with, *initial) ? WashIn::either : WashIn::apart;
    return a_.loss.explains(with, *initial) ? WashIn::apart : WashIn::pan;
  }

  /// A pan has no wash loss in it where nothing speaks for that; what passes a sieve may have.
  void check_unclear(const AccountColumn &column, const PrintedNumber &wash) const {
    if (const AccountRow *const all = rows_.all_fines())
      refuse_unclear(*all, a_.stated.wash_loss->label);
    const std::optional<PrintedNumber> rows = column.whole(), initial = in_unit_of(column, a_.stated.initial);
    if (rows && initial && rows->value + wash.value > initial->value)
      source_.refuse(
          rows_.pan() != nullptr ? rows_.pan()->line : a_.header_line,
          fmt::format("the pan may have the wash loss {} in it, or not: write 'Pan + wash' for both",
                      shown(wash.value)));
  }

  OrderedAccounts &a_;
  const AccountRows &rows_;
  const Source &source_;
  std::vector<std::string> &notes_;
};

} // namespace

OrderedAccounts in_order(SheetAccounts sheet, const AllowedLoss &loss, const Source &source,
                         std::vector<std::string> &notes) {
  AccountRows rows = rows_in_order(std::move(sheet.rows), sheet.unit, source);
  StatedMasses stated = stated_masses(sheet.stated, rows, sheet.columns[0], source);
  OrderedAccounts accounts{std::move(sheet.columns),
                           std::move(sheet.unread),
                           sheet.is_asked,
                           std::move(rows),
                           std::move(stated),
                           loss,
                           sheet.unit,
                           sheet.header_line};
  ColumnFiller(accounts, source, notes).fill_all();
  return accounts;
}

} // namespace mdm
