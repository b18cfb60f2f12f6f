#include "gradation/account_comparison.hpp"

#include "gradation/shown.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// The word of --kind that chooses such a column.
std::string_view kind_of(const AccountColumn &column) {
  const bool is_share = column.is_share(), is_fraction = column.meaning.unit == ColumnUnit::fraction;
  switch (column.meaning.meaning) {
  case ColumnMeaning::passing:
    return is_fraction ? "passing_fraction" : "passing_percent";
  case ColumnMeaning::cumulative:
    return is_share ? "cumulative_retained_percent" : "cumulative";
  default:
    return is_fraction ? "retained_fraction" : is_share ? "retained_percent" : "mass";
  }
}

/// What to do where two columns differ.
std::string remedy(const AccountColumn &first, const AccountColumn &second) {
  return kind_of(first) == kind_of(second)
             ? fmt::format("correct one, or choose with {} SIZE,VALUE", option("columns"))
             : fmt::format("correct one, or choose with {0} {1} or {0} {2}", option("kind"), kind_of(first),
                           kind_of(second));
}

/// The sieve where the readings are farthest apart, with the percentages that pass it.
struct FarthestApart {
  std::size_t sieve;
  Rational first, second;
};

/// Nothing where the percentages are not known, or the same.
std::optional<FarthestApart> farthest_apart(const AccountColumn &first, const AccountColumn &second) {
  std::optional<FarthestApart> farthest;
  Rational most = 0;
  for (std::size_t i = 0; i < first.sieves.size(); ++i) {
    const std::optional<Rational> p = first.passing_percent(i), q = second.passing_percent(i);
    if (!p || !q || abs(Rational(*p - *q)) <= most)
      continue;
    most = abs(Rational(*p - *q));
    farthest = {i, *p, *q};
  }
  return farthest;
}

/// True for a column that says by itself that something passes the finest sieve, whatever its rounding.
bool have_rest(const AccountColumn &column) {
  return !column.is_retained() && column.below && column.below->range().lo > 0;
}

/// True where both have one unit that is known.
bool share_unit(const AccountColumn &first, const AccountColumn &second) {
  return first.is_share() == second.is_share() && first.meaning.unit != ColumnUnit::none &&
         second.meaning.unit != ColumnUnit::none && first.grams == second.grams;
}

class ComparisonOfColumns {
public:
  ComparisonOfColumns(const OrderedAccounts &accounts, const Source &source, std::vector<std::string> &notes)
      : a_(accounts), source_(source), notes_(notes) {}

  ColumnsCompared run() {
    compare_all();
    find_deciding();
    return std::move(result_);
  }

private:
  const AccountColumn &column(std::size_t c) const { return a_.columns[c]; }
  std::string quoted(std::size_t c) const { return in_quotes(column(c).header); }
  std::string size(std::size_t sieve) const { return shown(a_.rows.sieves[sieve].size, a_.unit); }

  void compare_all() {
    constexpr std::size_t most = 12;
    const std::size_t count = a_.columns.size();
    for (std::size_t a = 0; a < count; ++a)
      for (std::size_t b = a + 1; b < count; ++b)
        if (a == 0 || count <= most)
          compare_pair(a, b);
    if (!agreeing_.empty())
      notes_.push_back(
          fmt::format("Columns that agree within the rounding of their digits: {}.", agreeing_.text()));
  }

  void compare_pair(std::size_t a, std::size_t b) {
    if (column(a).is_share() && !column(b).is_share())
      std::swap(a, b);
    const ColumnComparison comparison = compare(column(a), column(b));
    if (comparison.disagreement)
      return differ(a, b, *comparison.disagreement);
    const std::optional<std::string> below =
        comparison.whole ? difference_of_wholes(a, b, *comparison.whole) : difference_below(a, b);
    if (const std::optional<std::string> rest = difference_of_rest(a, b))
      return say(*rest);
    if (below)
      return say(*below);
    if (a != 0 && b != 0)
      return;
    if (lacks_share_of_rest(b))
      with_rest_.push_back(b);
    result_.some_agree = true;
    if (differs_below(a, b))
      return;
    if (agreeing_.empty())
      agreeing_.add(column(0).header);
    agreeing_.add(column(a == 0 ? b : a).header);
  }

  /// A difference is an error, or a note where the user has chosen.
  void say(const std::string &difference) {
    if (!a_.is_asked)
      source_.refuse(a_.header_line, difference);
    notes_.push_back(fmt::format("{}; {} was asked for.", difference, quoted(0)));
  }

  void differ(std::size_t a, std::size_t b, std::size_t sieve) {
    const std::string what_to_do = remedy(column(a), column(b));
    if (const std::optional<FarthestApart> f = farthest_apart(column(a), column(b)))
      return say(fmt::format("at {} {} percent pass by the column {}, {} by {}: {}", size(f->sieve),
                             shown_hundredths(f->first), quoted(a), shown_hundredths(f->second), quoted(b),
                             what_to_do));
    say(fmt::format("the columns {} and {} differ at {}: {}", quoted(a), quoted(b), size(sieve), what_to_do));
  }

  /// True for masses of the sieves alone beside a column by which something passes the finest sieve.
  bool lacks_rest(const AccountColumn &masses, const AccountColumn &other) const {
    return !a_.rows.have_fines() && masses.adds_masses() && have_rest(other);
  }

  /// True for a chosen column of the sieves' shares alone beside such a column.
  bool lacks_share_of_rest(std::size_t other) const {
    return !a_.rows.have_fines() && column(0).is_share() && column(0).is_retained() && !column(0).below &&
           have_rest(column(other));
  }

  /// True where the difference of what passes the finest sieve is that of the rounding of all sieves: percent
  /// passing may have been made of rounded percent retained.
  static bool may_be_rounded(const AccountColumn &first, const AccountColumn &second) {
    const std::optional<PrintedNumber> sieves = (first.is_retained() ? first : second).retained();
    return first.is_share() && first.is_retained() != second.is_retained() && sieves &&
           agree(*first.below, PrintedNumber{second.below->value, second.below->half + sieves->half});
  }

  /// True where two columns of one unit differ in what passes the finest sieve by no more than their
  /// rounding, or than what was lost, which is in what passes and not in the pan.
  bool may_be_lost(const AccountColumn &first, const AccountColumn &second) const {
    if (agree_below(first, second) || may_be_rounded(first, second))
      return true;
    const AccountColumn &pan = first.is_retained() ? first : second,
                        &other = first.is_retained() ? second : first;
    if (pan.is_share() && pan.is_retained() != other.is_retained() && pan.below->value > other.below->value)
      return false;
    return a_.loss.explains(*first.below, *second.below, first.whole()->value);
  }

  /// True where both may have one number, as it stands or but for what was washed out.
  bool agree_below(const AccountColumn &first, const AccountColumn &second) const {
    return agree(*first.below, *second.below) || lacks_wash(first, second) || lacks_wash(second, first);
  }

  /// True for a share of the pan without what was washed out, which stands in no row, beside what passes.
  bool lacks_wash(const AccountColumn &pan, const AccountColumn &passing) const {
    const std::optional<StatedMass> &wash = a_.stated.wash_loss, &initial = a_.stated.initial;
    return pan.is_share() && pan.is_retained() && a_.has_added_wash && wash && initial &&
           initial->mass.value > initial->mass.half &&
           agree(*pan.below + share_of(wash->mass, initial->mass), *passing.below);
  }

  /// True where they differ in it by more than their own rounding, which is said.
  bool differs_below(std::size_t a, std::size_t b) {
    const AccountColumn &first = column(a), &second = column(b);
    if (!first.below || !second.below || !share_unit(first, second) || agree_below(first, second))
      return false;
    const std::string first_value = shown(first.below->value), second_value = shown(second.below->value);
    notes_.push_back(
        may_be_rounded(first, second)
            ? fmt::format(
                  "{} passes the finest sieve by the column {}, {} by {}: their rounding may account for it.",
                  first_value, quoted(a), second_value, quoted(b))
            : fmt::format(
                  "{} passes the finest sieve by the column {}, {} by {}: the difference may have been lost.",
                  first_value, quoted(a), second_value, quoted(b)));
    return true;
  }

  /// What passes the finest sieve by two columns of one unit.
  std::optional<std::string> difference_below(std::size_t a, std::size_t b) const {
    const AccountColumn &first = column(a), &second = column(b);
    if (lacks_rest(first, second) && share_unit(first, second))
      return fmt::format(
          "{} passes the finest sieve by the column {}, and {} has no row of the pan: write it",
          shown(second.below->value), quoted(b), quoted(a));
    if (!first.below || !second.below || !share_unit(first, second) || !first.whole() ||
        may_be_lost(first, second))
      return std::nullopt;
    return fmt::format("{} passes the finest sieve by the column {}, {} by {}: {}", shown(first.below->value),
                       quoted(a), shown(second.below->value), quoted(b), remedy(first, second));
  }

  /// What passes the finest sieve by the masses in `a` and by the single shares in `b`.
  std::optional<std::string> difference_of_rest(std::size_t a, std::size_t b) const {
    const AccountColumn &masses = column(a), &shares = column(b);
    const std::optional<PrintedNumber> sum = masses.whole();
    if (!masses.adds_masses() || !shares.is_share() || !shares.is_retained() || !masses.below ||
        !shares.below || !sum || sum->value <= sum->half)
      return std::nullopt;
    const Rational percent = 100 * masses.below->value / sum->value;
    const auto is_pan = [&](const PrintedNumber &mass) {
      return a_.loss.explains(*shares.below, {100 * mass.value / sum->value, 100 * mass.half / sum->value},
                              100);
    };
    // The share of the pan may be without what was washed out, which stands in no row.
    const std::optional<PrintedNumber> wash =
        a_.has_added_wash ? in_unit_of(masses, a_.stated.wash_loss) : std::nullopt;
    if (is_pan(*masses.below) || (wash && is_pan(*masses.below - *wash)))
      return std::nullopt;
    return fmt::format("{} percent pass the finest sieve by the column {}, {} by {}: {}",
                       shown(shares.below->value), quoted(b), shown_hundredths(percent), quoted(a),
                       remedy(masses, shares));
  }

  /// The sum of the masses in `a`, which is `whole` by the shares in `b`.
  std::optional<std::string> difference_of_wholes(std::size_t a, std::size_t b, const Interval &whole) {
    const AccountColumn &masses = column(a);
    const std::optional<PrintedNumber> sum = masses.whole();
    if (!sum)
      return std::nullopt;
    if (lacks_rest(masses, column(b)) && sum->range().lo <= whole.hi) {
      with_rest_.push_back(b);
      result_.whole = whole;
      return std::nullopt;
    }
    if (agree(*sum, whole) && may_have_shares(masses, column(b)))
      return std::nullopt;
    const bool is_rest_elsewhere = std::any_of(a_.columns.begin(), a_.columns.end(), have_rest);
    if (column(b).is_retained() && !column(b).below && !a_.rows.have_fines() && is_rest_elsewhere &&
        sum->range().lo <= whole.hi)
      return std::nullopt; // both lack what passes the finest sieve, which another column says
    for (const std::optional<PrintedNumber> &other :
         {number_of(a_.rows.total(), a), in_unit_of(masses, a_.stated.initial)})
      if (other && agree(*other, whole) && a_.loss.explains(*other, *sum))
        return std::nullopt;
    const char *const difference =
        !masses.below && sum->range().hi < whole.lo
            ? "the masses in {} add up to {}, and the percent in {} are of {} to {}: write the row 'pan' if "
              "the "
              "rest passes the finest sieve, else {}"
            : "the masses in {} add up to {}, and the percent in {} are of {} to {}: {}";
    return fmt::format(fmt::runtime(difference), quoted(a), shown(sum->value), quoted(b),
                       shown_hundredths(whole.lo), shown_hundredths(whole.hi), remedy(masses, column(b)));
  }

  /// Masses without a row of the pan give way to a column that says what passes the finest sieve.
  void find_deciding() {
    if (with_rest_.empty() || !(column(0).adds_masses() || column(0).is_retained()))
      return;
    const auto is_full = [this](std::size_t c) {
      return std::all_of(column(c).sieves.begin(), column(c).sieves.end(),
                         [](const std::optional<PrintedNumber> &n) { return n.has_value(); });
    };
    const auto found = std::find_if(with_rest_.begin(), with_rest_.end(), is_full);
    if (found == with_rest_.end())
      source_.refuse(
          a_.header_line,
          fmt::format("the masses in {} have no row of the pan, and {}, by which something passes the "
                      "finest sieve, has empty cells: fill them, or write the row of the pan",
                      quoted(0), quoted(with_rest_[0])));
    result_.deciding = *found;
    notes_.push_back(fmt::format("The masses in {} have no row of the pan; {} decides, where {} "
                                 "percent pass the finest sieve, {}.",
                                 quoted(0), quoted(*found), shown(column(*found).below->value),
                                 shown(a_.rows.sieves.back().size, a_.unit)));
  }

  const OrderedAccounts &a_;
  const Source &source_;
  std::vector<std::string> &notes_;
  ColumnsCompared result_;
  std::vector<std::size_t> with_rest_; ///< by which something passes the finest sieve
  ShortList agreeing_;                 ///< with the chosen one
};

} // namespace

ColumnsCompared compare_columns(const OrderedAccounts &accounts, const Source &source,
                                std::vector<std::string> &notes) {
  return ComparisonOfColumns(accounts, source, notes).run();
}

} // namespace mdm
