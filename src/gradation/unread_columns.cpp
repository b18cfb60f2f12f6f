#include "gradation/unread_columns.hpp"

#include "gradation/column_words.hpp"
#include "gradation/plain_words.hpp"
#include "text/option_name.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace mdm {
namespace {

constexpr std::string_view of_values =
    "mass masses masse massen weight weights wt gewicht gewichte peso pesos poids masa masas massa "
    "retained retd passing passante passant finer coarser corr adj norm recalc korr normalized normalised "
    "recalculated weighted "
    "washed corrected adjusted combined overall net netto total totals totale totali totales sum summe "
    "somme suma somma gesamt korrigiert korrigierte corrige corrigee corregido corregida corretto corretta";
/// Words beside these that leave a column one of the sample's masses; any other may be of a target, a tare,
/// an assay or the moisture.
constexpr std::string_view beside_values =
    "of the a an x by in on to per and all whole each sample material dry soil value values final new calc "
    "calculated computed result results factor part anteil probe amount quantity auswaage von der des und de "
    "del du la le y et";
/// The same beside percent; a mass may be that of a sieve.
constexpr std::string_view beside_percent =
    "sieve sieves size n p actual reported rounded indiv individual differential frequency 1 2 3";

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
  std::vector<Rational> numbers;
  for (const std::optional<PrintedNumber> &number : unread.sieves)
    if (number)
      numbers.push_back(number->value);
  if (meaning == ColumnMeaning::passing)
    std::reverse(numbers.begin(), numbers.end());
  return std::is_sorted(numbers.begin(), numbers.end());
}

/// The first meaning with which the column agrees; nothing where there is none.
std::optional<ColumnMeaning> meaning_of(const AccountColumn &values, AccountColumn unread,
                                        const AllowedLoss &loss) {
  for (const ColumnMeaning meaning : readings) {
    unread.meaning.meaning = meaning;
    const bool is_first = !values.is_share() || unread.is_share();
    const ColumnComparison compared = is_first ? compare(values, unread) : compare(unread, values);
    if (may_be(meaning, unread) && !compared.disagreement &&
        (!compared.whole || is_whole(is_first ? values : unread, *compared.whole, loss)))
      return meaning;
  }
  return std::nullopt;
}

/// True where shares of that meaning say that something passes the finest sieve.
bool have_rest(const AccountColumn &shares, ColumnMeaning meaning) {
  const std::optional<PrintedNumber> &last = shares.sieves.back();
  if (!shares.is_share() || !last)
    return false;
  return (meaning == ColumnMeaning::passing && last->range().lo > 0) ||
         (meaning == ColumnMeaning::cumulative && last->range().hi < 100);
}

} // namespace

bool may_hold_values(std::string_view header) {
  const std::vector<std::string> words = words_of(header);
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
    const bool lacks_rest = meaning && values.adds_masses() && !values.below && have_rest(unread, *meaning);
    if (meaning && !lacks_rest)
      continue;
    const std::string difference =
        lacks_rest
            ? fmt::format("something passes the finest sieve by the column {}, and {} has no row of the pan",
                          in_quotes(unread.header), in_quotes(values.header))
            : fmt::format("the column {} has other masses or shares than {}", in_quotes(unread.header),
                          in_quotes(values.header));
    if (!accounts.is_asked)
      source.refuse(accounts.header_line,
                    fmt::format("{}: choose one with {} SIZE,VALUE", difference, option("columns")));
    notes.push_back(fmt::format("{}; {} was asked for.", difference, in_quotes(values.header)));
  }
}

} // namespace mdm
