#include "gradation/unread_columns.hpp"

#include "gradation/column_words.hpp"
#include "gradation/limit_columns.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_words.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::string_view of_values =
    "mass masses masse massen weight weights wt gewicht gewichte peso pesos poids masa masas massa "
    "retained retd passing passante passant finer coarser corr adj norm recalc korr normalized normalised "
    "recalculated weighted average avg mean mittel mittelwert moyenne media duplicate repeat trial "
    "share shares result results "
    "washed corrected adjusted combined overall net netto total totals totale totali totales sum summe "
    "somme suma somma gesamt korrigiert korrigierte corrige corrigee corregido corregida corretto corretta";
/// Words beside these that leave a column one of the sample's masses; any other may be of a target, a tare,
/// an assay or the moisture.
constexpr std::string_view beside_values =
    "of the a an x by in on to per and all whole each sample material dry soil value values final new calc "
    "calculated computed factor part anteil probe amount quantity auswaage von der des und de "
    "del du la le y et";
/// The same beside percent; a mass may be that of a sieve.
constexpr std::string_view beside_percent =
    "sieve sieves size n p actual reported rounded indiv individual differential frequency 1 2 3";
/// Words of percent that are of no mass of a row: of a specification, of errors, and of an assay.
constexpr std::string_view of_other_percent =
    "spec specification specified target required requirement envelope limit limits grading soll sollwert "
    "jmf design error errors deviation std stdev sd rsd cv difference diff delta uncertainty repeatability "
    "recovery tolerance fehler abweichung differenz toleranz ecart tolerancia scarto error desviacion "
    "assay grade ash loi organic carbonate caco3 fe cu zn pb ag au ni mn ti sio2 al2o3 fe2o3 cao mgo tio2 "
    "p2o5 s c";
constexpr std::string_view of_changes = "factor faktor facteur fattore multiplier scale scaling ratio "
                                        "teilung x coefficient koeffizient weighting "
                                        "dilution tested moisture water wasser wassergehalt feuchte w wc mc "
                                        "solids eau agua humedad acqua umidita";

/// What the numbers of such a column may be.
constexpr std::array readings = {ColumnMeaning::retained, ColumnMeaning::cumulative, ColumnMeaning::passing};

/// True where the sample's mass is that of which the shares are, or is not known as it lacks the pan.
bool is_whole(const AccountColumn &masses, const Interval &whole, const AllowedLoss &loss) {
  const std::optional<PrintedNumber> sum = masses.whole();
  return !sum || !masses.below || agree(*sum, whole) ||
         loss.explains(*sum, {(whole.lo + whole.hi) / 2, (whole.hi - whole.lo) / 2});
}

/// True where numbers never fall, or never grow, from the coarsest sieve to the finest, as sums do.
bool may_be(ColumnMeaning meaning, const AccountColumn &unread) {
  if (meaning == ColumnMeaning::retained)
    return true;
  std::vector<Rational> numbers = unread.numbers();
  if (meaning == ColumnMeaning::passing)
    std::reverse(numbers.begin(), numbers.end());
  return std::is_sorted(numbers.begin(), numbers.end());
}

/// True where masses are the difference of two columns, row by row. \pre values are of single sieves
bool are_differences(const AccountColumn &values, const AccountColumn &full, const AccountColumn &empty) {
  for (std::size_t i = 0; i < values.sieves.size(); ++i) {
    const std::optional<PrintedNumber> &net = values.sieves[i], &gross = full.sieves[i],
                                       &tare = empty.sieves[i];
    if (net && (!gross || !tare || !agree(*net, *gross - *tare)))
      return false;
  }
  return true;
}

/// True where a column has the masses with that of one container. \pre as above
bool is_with_one_tare(const AccountColumn &values, const AccountColumn &full) {
  Rational least = 0;
  std::optional<Rational> most;
  for (std::size_t i = 0; i < values.sieves.size(); ++i) {
    const std::optional<PrintedNumber> &net = values.sieves[i], &gross = full.sieves[i];
    if (!net || !gross)
      return false;
    const Interval tare = (*gross - *net).range();
    least = std::max(least, tare.lo);
    most = most ? std::min(*most, tare.hi) : tare.hi;
  }
  return most && least > 0 && least <= *most;
}

/// True for a column of masses with a container, or of the containers, beside those without.
bool is_of_weighing(const AccountColumn &values, const AccountColumn &unread,
                    const std::vector<AccountColumn> &others) {
  if (!values.is_retained() || values.is_share())
    return false;
  return is_with_one_tare(values, unread) ||
         std::any_of(others.begin(), others.end(), [&](const AccountColumn &other) {
           return &other != &unread &&
                  (are_differences(values, unread, other) || are_differences(values, other, unread));
         });
}

/// True where the column has what stays below each size, as instruments write the shares of their channels
/// beside what passes.
bool is_of_classes_below(const AccountColumn &values, AccountColumn unread) {
  if (values.meaning.meaning != ColumnMeaning::passing || !unread.sieves.back())
    return false;
  unread.sieves.insert(unread.sieves.begin(), PrintedNumber{0, 0});
  unread.sieves.pop_back();
  unread.meaning.meaning = ColumnMeaning::retained;
  return unread.is_share() && !compare(values, unread).disagreement;
}

/// True where masses that pass, of which the whole is so much, have other than the share of the finest sieve.
bool differs_below(const AccountColumn &shares, const AccountColumn &passing,
                   const std::optional<Interval> &whole) {
  const std::optional<PrintedNumber> &last = passing.sieves.back();
  if (!shares.below || !last || !whole || whole->lo <= 0)
    return false;
  const Interval share{100 * last->range().lo / whole->hi, 100 * last->range().hi / whole->lo};
  return share.hi < shares.below->range().lo || share.lo > shares.below->range().hi;
}

/// The first meaning with which the column agrees; nothing where there is none.
std::optional<ColumnMeaning> meaning_of(const AccountColumn &values, AccountColumn unread,
                                        const AllowedLoss &loss) {
  for (const ColumnMeaning meaning : readings) {
    unread.meaning.meaning = meaning;
    const bool is_first = !values.is_share() || unread.is_share();
    const ColumnComparison compared = is_first ? compare(values, unread) : compare(unread, values);
    if (meaning == ColumnMeaning::passing && !is_first && differs_below(values, unread, compared.whole))
      continue;
    if (may_be(meaning, unread) && !compared.disagreement &&
        (!compared.whole || is_whole(is_first ? values : unread, *compared.whole, loss)))
      return meaning;
  }
  return std::nullopt;
}

/// True where shares of that meaning say that something passes the finest sieve.
bool have_rest(const AccountColumn &shares, ColumnMeaning meaning, const AllowedLoss &loss) {
  const std::optional<PrintedNumber> &last = shares.sieves.back();
  if (!shares.is_share() || !last)
    return false;
  if (meaning == ColumnMeaning::retained) {
    const std::optional<PrintedNumber> sum = shares.retained();
    return sum && sum->value < 100 && !loss.explains(*sum, {100, 0}, 100);
  }
  return (meaning == ColumnMeaning::passing && last->range().lo > 0) ||
         (meaning == ColumnMeaning::cumulative && last->range().hi < 100);
}

/// True for a header with a unit of mass or percent that nothing says to be of another thing, or of a tare.
bool names_amount(std::string_view header, const std::vector<std::string> &words) {
  const ColumnUnit unit = unit_in_header(header);
  const bool is_mass = unit == ColumnUnit::mass || row_words(header).meaning == RowMeaning::container;
  return (is_mass || (unit == ColumnUnit::percent && !has_any_word(of_other_percent, words))) &&
         !is_limit(header) && !changes_masses(header);
}

} // namespace

bool changes_masses(std::string_view header) {
  return has_any_word(of_changes, words_of(header));
}

bool may_hold_values(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
  if (names_amount(header, words))
    return true;
  const auto is_value = [](const std::string &word) {
    const ColumnUnit unit = unit_of_words(word);
    return unit == ColumnUnit::percent || unit == ColumnUnit::mass || is_word_of_sums(word) ||
           has_word(of_values, word);
  };
  const bool is_percent = std::any_of(words.begin(), words.end(), [](const std::string &word) {
    return unit_of_words(word) == ColumnUnit::percent;
  });
  return std::any_of(words.begin(), words.end(), is_value) &&
         std::all_of(words.begin(), words.end(), [&is_value, is_percent](const std::string &word) {
           return is_value(word) || has_word(beside_values, word) ||
                  (is_percent && has_word(beside_percent, word));
         });
}

void check_unread(const OrderedAccounts &accounts, std::size_t deciding, const Source &source,
                  std::vector<std::string> &notes) {
  const AccountColumn &values = accounts.columns[deciding];
  for (const AccountColumn &unread : accounts.unread) {
    const std::optional<ColumnMeaning> meaning = meaning_of(values, unread, accounts.loss);
    const bool lacks_rest =
        meaning && values.adds_masses() && !values.below && have_rest(unread, *meaning, accounts.loss);
    if (meaning ? !lacks_rest
                : is_of_weighing(values, unread, accounts.unread) || is_of_classes_below(values, unread))
      continue;
    const std::string difference =
        lacks_rest
            ? fmt::format("something passes the finest sieve by the column {}, and {} has no row of the pan",
                          in_quotes(unread.header), in_quotes(values.header))
            : fmt::format("the column {} has other masses or shares than {}", in_quotes(unread.header),
                          in_quotes(values.header));
    if (!accounts.is_asked)
      source.refuse(
          accounts.header_line,
          lacks_rest ? fmt::format("{}: write it with what passes, or choose one with {} SIZE,VALUE",
                                   difference, option("columns"))
                     : fmt::format("{}: choose one with {} SIZE,VALUE, and say with {} what its header does "
                                   "not",
                                   difference, option("columns"), option("kind")));
    notes.push_back(fmt::format("{}; {} was asked for.", difference, in_quotes(values.header)));
  }
}

} // namespace mdm
