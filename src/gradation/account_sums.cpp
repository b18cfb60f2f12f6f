#include "gradation/account_sums.hpp"

#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

class SumCheck {
public:
  SumCheck(const OrderedAccounts &accounts, const ColumnsCompared &compared, const Source &source,
           std::vector<std::string> &notes)
      : a_(accounts), rows_(accounts.rows), stated_(accounts.stated), compared_(compared), source_(source),
        notes_(notes), mass_column_(mass_column()) {}

  bool run() {
    for (std::size_t c = 0; c < a_.columns.size(); ++c)
      if (const std::optional<PrintedNumber> total = number_of(rows_.total(), c))
        check_total(c, *total, *rows_.total());
    if (mass_column_) {
      if (const std::optional<PrintedNumber> total = in_unit_of(column(*mass_column_), stated_.total))
        check_total(*mass_column_, *total, *stated_.total);
      check_initial(*mass_column_);
      check_missing_pan(*mass_column_);
      check_uncompared(*mass_column_);
      check_washed(*mass_column_);
      check_loss(*mass_column_);
    } else {
      check_share_of_loss();
    }
    check_percent_of_loss();
    if (deciding().is_share()) {
      check_percent_retained();
      check_percent_washed();
    }
    check_percent_of_fines();
    return adds_up_;
  }

private:
  const AccountColumn &column(std::size_t c) const { return a_.columns[c]; }
  const AccountColumn &deciding() const { return column(compared_.deciding); }
  std::string quoted(std::size_t c) const { return in_quotes(column(c).header); }

  /// The column of masses that is added up: the chosen one, or one beside percent.
  std::optional<std::size_t> mass_column() const {
    const auto found = std::find_if(a_.columns.begin(), a_.columns.end(),
                                    [](const AccountColumn &column) { return column.adds_masses(); });
    return found == a_.columns.end() ? std::nullopt
                                     : std::optional(static_cast<std::size_t>(found - a_.columns.begin()));
  }

  /// `where` has the label and the line.
  template <typename Where>
  void check_total(std::size_t c, const PrintedNumber &total, const Where &where) {
    const AccountColumn &here = column(c);
    if (!here.is_retained() && here.is_share()) {
      if (total.value != 0 && total.value != 100)
        notes_.push_back(
            fmt::format("{} has {} in the column {}, which is no sum of masses and was not compared.",
                        in_quotes(where.label), shown(total.value), quoted(c)));
      return;
    }
    const std::optional<PrintedNumber> whole = here.whole();
    if (here.meaning.meaning == ColumnMeaning::passing || !whole)
      return;
    const std::string label = in_quotes(where.label);
    const auto is_equal = [](const PrintedNumber &a, const PrintedNumber &b) { return a.value == b.value; };
    const std::string_view exactly = is_equal(*whole, total) ? "" : sum_of_some(c, *whole, total, is_equal);
    if (exactly.empty() && agree(*whole, total)) {
      adds_up_ = true;
      notes_.push_back(
          whole->value == total.value
              ? fmt::format("The rows of {} add up to {} as {} says.", quoted(c), shown(total.value), label)
              : fmt::format("The rows of {} add up to {}, {} says {}: their rounding may account for it.",
                            quoted(c), shown(whole->value), label, shown(total.value)));
    } else if (const std::string_view words =
                   exactly.empty() ? sum_of_some(c, *whole, total, agree) : exactly;
               !words.empty()) {
      notes_.push_back(fmt::format("The rows of {} add up to {}, {} says {}: {}.", quoted(c),
                                   shown(whole->value), label, shown(total.value), words));
    } else {
      compare_masses(c, *whole, total, where, a_.loss.is_asked() ? a_.loss.percent() : Rational(0));
    }
  }

  /// What a total is without the pan, without the wash loss, or with what was lost, or as the shares that
  /// decide have it; empty where it is none of these.
  /// \param same  the two numbers may be one
  std::string_view sum_of_some(std::size_t c, const PrintedNumber &whole, const PrintedNumber &total,
                               bool (*same)(const PrintedNumber &, const PrintedNumber &)) const {
    const AccountColumn &here = column(c);
    const std::optional<PrintedNumber> sieves = here.retained(), wash = in_unit_of(here, stated_.wash_loss),
                                       row = number_of(rows_.wash(), c), loss = number_of(rows_.loss(), c);
    if (sieves && same(*sieves, total))
      return "that is what is on the sieves";
    if ((wash && same(whole - *wash, total)) || (row && here.is_retained() && same(whole - *row, total)))
      return "that is without the wash loss";
    if (loss && same(whole + *loss, total))
      return "that is with what was lost";
    if (compared_.whole && compared_.deciding != c && agree(total, *compared_.whole))
      return "that is what the shares are of";
    return {};
  }

  /// Two sums of one sample: a note, or an error beyond what may be lost, in percent. `where` has the label
  /// and the line.
  template <typename Where>
  void compare_masses(std::size_t c, const PrintedNumber &rows, const PrintedNumber &said, const Where &where,
                      const Rational &allowed) {
    const Rational difference = said.value - rows.value;
    const Rational percent = said.value == 0 ? Rational(100) : Rational(100 * abs(difference) / said.value);
    if (percent <= allowed) {
      adds_up_ = true;
      notes_.push_back(fmt::format("The rows of {} add up to {}, {} says {}: {} percent {}; the rows are "
                                   "used.",
                                   quoted(c), shown(rows.value), in_quotes(where.label), shown(said.value),
                                   shown_hundredths(percent), difference > 0 ? "less" : "more"));
      return;
    }
    source_.refuse(where.line,
                   fmt::format("the rows of {} add up to {}, and {} says {}, a difference of {} percent "
                               "of that: {}, or allow it with {}; {}",
                               quoted(c), shown(rows.value), in_quotes(where.label), shown(said.value),
                               shown_hundredths(percent), remedy_of_sum(c, said, difference > 0),
                               option("loss"), split_remedy()));
  }

  /// What to do where rows do not add up to what is said.
  std::string remedy_of_sum(std::size_t c, const PrintedNumber &said, bool is_short) const {
    const AccountColumn &here = column(c);
    if (is_short && !here.below)
      return "write the row 'pan' or 'Wash loss' if the rest passes the finest sieve";
    const std::optional<PrintedNumber> &last = here.sieves.back();
    if (!is_short && here.is_retained() && last && a_.loss.explains(*last, said))
      return fmt::format("say {} cumulative if {} is cumulative, else correct the sheet", option("kind"),
                         quoted(c));
    return "correct the sheet";
  }

  void check_initial(std::size_t c) {
    const std::optional<PrintedNumber> sum = column(c).whole();
    if (!sum)
      return;
    for (const std::optional<StatedMass> *stated : {&stated_.initial, &stated_.sieved}) {
      const std::optional<PrintedNumber> mass = in_unit_of(column(c), *stated);
      if (!mass)
        continue;
      if (agree(*sum, *mass))
        adds_up_ = true;
      else if (!(stated == &stated_.sieved && is_without_wash(c, *sum, *mass)) &&
               !is_whole_of_shares(*mass) && !(a_.is_asked && column(0).is_share()))
        compare_masses(c, *sum, *mass, **stated, a_.loss.percent());
    }
  }

  /// True for the mass before sieving of a sample that was washed.
  bool is_without_wash(std::size_t c, const PrintedNumber &sum, const PrintedNumber &mass) const {
    const std::optional<PrintedNumber> wash = in_unit_of(column(c), stated_.wash_loss);
    const std::optional<PrintedNumber> gone = wash ? wash : number_of(rows_.wash(), c);
    return gone && a_.loss.explains(sum - *gone, mass);
  }

  bool is_whole_of_shares(const PrintedNumber &mass) const {
    const std::optional<Interval> &whole = compared_.whole;
    return whole && a_.loss.explains(mass, {(whole->lo + whole->hi) / 2, (whole->hi - whole->lo) / 2});
  }

  /// The mass after washing must be that of the rows, and what was washed out must be there.
  void check_washed(std::size_t c) {
    const AccountColumn &here = column(c);
    const std::optional<PrintedNumber> washed = in_unit_of(here, stated_.washed), sum = here.whole();
    if (!washed || !sum)
      return;
    const std::optional<PrintedNumber> stated = in_unit_of(here, stated_.wash_loss);
    const std::optional<PrintedNumber> row = here.is_retained() ? number_of(rows_.wash(), c) : std::nullopt;
    if (const std::optional<PrintedNumber> gone = stated ? stated : row) {
      if (!compared_.whole && !agree(*sum - *gone, *washed))
        compare_masses(c, *sum - *gone, *washed, *stated_.washed, a_.loss.percent());
    } else if (!rows_.have_wash() && compared_.deciding == c && !a_.is_asked) {
      source_.refuse(
          stated_.washed->line,
          fmt::format("{} is given, and nothing of what was washed out: write the row 'Wash loss', or "
                      "'Dry mass before wash' above the table",
                      in_quotes(stated_.washed->label)));
    }
  }

  /// What was lost in sieving belongs to no sieve.
  void check_loss(std::size_t c) {
    if (const std::optional<PrintedNumber> loss = number_of(rows_.loss(), c))
      check_loss(c, *loss, *rows_.loss());
    else if (stated_.sieve_loss)
      check_loss(c, *in_unit_of(column(c), stated_.sieve_loss), *stated_.sieve_loss);
  }

  /// `where` has the label and the line.
  template <typename Where>
  void check_loss(std::size_t c, const PrintedNumber &loss, const Where &where) {
    const std::optional<PrintedNumber> whole = column(c).whole();
    if (whole && !a_.loss.explains(loss, {0, 0}, whole->value))
      source_.refuse(where.line, fmt::format("{} is {}, more than {} percent of {}: allow it with {}",
                                             in_quotes(where.label), shown(loss.value),
                                             shown(a_.loss.percent()), shown(whole->value), option("loss")));
    notes_.push_back(
        fmt::format("{} is {}; it belongs to no sieve.", in_quotes(where.label), shown(loss.value)));
  }

  /// Where no row says what passes the finest sieve, any mass may.
  void check_missing_pan(std::size_t c) const {
    if (column(c).below || compared_.deciding != c || stated_.initial)
      return;
    for (const StatedMass &stated : stated_.uncompared)
      if (stated.mass.value != 0)
        source_.refuse(
            stated.line,
            fmt::format(
                "{} may pass the finest sieve, and the table has no row of the pan: write it as a row "
                "'Pan' or 'Wash loss' if it does, else the row 'Pan' with what does, or 0",
                in_quotes(stated.label)));
  }

  /// A mass that is more than all rows together may be the sample before something was lost.
  void check_uncompared(std::size_t c) const {
    const std::optional<PrintedNumber> whole = column(c).whole();
    if (!whole || stated_.initial)
      return;
    for (const StatedMass &stated : stated_.uncompared)
      if (const PrintedNumber mass = *in_unit_of(column(c), stated);
          mass.range().lo > whole->range().hi && !a_.loss.explains(*whole, mass))
        source_.refuse(
            stated.line,
            fmt::format("{} is {}, more than the {} of all rows: write 'Initial dry mass' if it is the mass "
                        "of the sample, else leave it out",
                        in_quotes(stated.label), shown(mass.value), shown(whole->value)));
  }

  /// The row of a loss where all columns have shares.
  void check_share_of_loss() {
    const std::optional<PrintedNumber> loss = number_of(rows_.loss(), compared_.deciding);
    if (!loss || loss->value == 0)
      return;
    const std::string label = in_quotes(rows_.loss()->label);
    if (!a_.loss.explains(*loss, {0, 0}, 100))
      source_.refuse(rows_.loss()->line,
                     fmt::format("{} is {} percent, more than {}: allow it with {}, or correct the sheet",
                                 label, shown(loss->value), shown(a_.loss.percent()), option("loss")));
    notes_.push_back(fmt::format("{} is {} percent; it belongs to no sieve.", label, shown(loss->value)));
  }

  void check_percent_of_loss() const {
    const std::optional<StatedMass> &percent = stated_.sieve_loss_percent;
    if (percent && !a_.loss.explains(percent->mass, {0, 0}, 100))
      source_.refuse(percent->line,
                     fmt::format("{} is {} percent: allow it with {}", in_quotes(percent->label),
                                 shown(percent->mass.value), option("loss")));
  }

  /// Percent retained must be of the whole.
  void check_percent_retained() const {
    const std::optional<PrintedNumber> sum = deciding().whole();
    if (deciding().is_retained() && !a_.is_asked && sum && !a_.loss.explains(*sum, {100, 0}))
      source_.refuse(a_.header_line, fmt::format("percent retained add up to {}: {}", shown(sum->value),
                                                 remedy_of_retained(*sum)));
  }

  std::string remedy_of_retained(const PrintedNumber &sum) const {
    if (sum.value > 100)
      return fmt::format("if {0} is cumulative, say {1} cumulative, else {1} retained_percent",
                         quoted(compared_.deciding), option("kind"));
    const std::string rest = shown(Rational(100 - sum.value));
    const std::vector<Rational> numbers = deciding().numbers();
    return std::is_sorted(numbers.begin(), numbers.end()) // as sums are
               ? fmt::format("say {} cumulative if each has what coarser sieves retain, else write the row "
                             "'pan' with {}",
                             option("kind"), rest)
               : fmt::format("write the row 'pan' with {} if that passes the finest sieve, or take them as "
                             "they are with {} retained_percent",
                             rest, option("kind"));
  }

  /// Percent that pass must have the wash loss.
  void check_percent_washed() const {
    const std::optional<StatedMass> &percent = stated_.wash_percent, &loss = stated_.wash_loss,
                                    &initial = stated_.initial;
    std::optional<PrintedNumber> washed = percent ? std::optional(percent->mass) : std::nullopt;
    if (!washed && loss && initial && initial->mass.value > initial->mass.half)
      washed = share_of(loss->mass, initial->mass);
    const std::optional<PrintedNumber> &below = deciding().below;
    if (washed && !a_.is_asked && (below ? below->range().hi : Rational(0)) < washed->range().lo)
      source_.refuse(
          (percent ? percent : loss)->line,
          fmt::format("{} percent were washed out, and only {} pass the finest sieve by the column {}: "
                      "correct one of them",
                      shown_hundredths(washed->value), below ? shown(below->value) : "0",
                      quoted(compared_.deciding)));
  }

  /// What a sheet calls fines passes a sieve of some 0.06 mm, and any coarser one.
  void check_percent_of_fines() const {
    const std::optional<PrintedNumber> whole = deciding().whole();
    if (a_.is_asked || !whole || whole->value <= whole->half ||
        rows_.sieves.back().size * in_mm(a_.unit) < ratio(6, 100))
      return;
    const std::optional<PrintedNumber> &below = deciding().below;
    const PrintedNumber passing = below ? share_of(*below, *whole) : PrintedNumber{0, 0};
    for (const StatedMass &fines : stated_.fines_percent)
      if (passing.range().hi < fines.mass.range().lo)
        source_.refuse(fines.line,
                       fmt::format("{} is {} percent, and only {} pass the finest sieve by the column {}: "
                                   "write a row 'Wash loss' with the mass if it was washed out, else "
                                   "correct one of them",
                                   in_quotes(fines.label), shown(fines.mass.value),
                                   shown_hundredths(passing.value), quoted(compared_.deciding)));
  }

  const OrderedAccounts &a_;
  const AccountRows &rows_;
  const StatedMasses &stated_;
  const ColumnsCompared &compared_;
  const Source &source_;
  std::vector<std::string> &notes_;
  std::optional<std::size_t> mass_column_;
  bool adds_up_ = false; ///< to a sum that the sheet states
};

} // namespace

bool check_sums(const OrderedAccounts &accounts, const ColumnsCompared &compared, const Source &source,
                std::vector<std::string> &notes) {
  return SumCheck(accounts, compared, source, notes).run();
}

} // namespace mdm
