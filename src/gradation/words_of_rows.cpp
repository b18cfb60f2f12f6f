#include "gradation/words_of_rows.hpp"

#include "gradation/account_rows.hpp"
#include "gradation/plain_words.hpp"
#include "gradation/row_words.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

std::string first_word(std::string_view cell) {
  const std::string words = plain_words(cell);
  return words.substr(0, words.find(' '));
}

/// `Page 2`, where a long table goes on.
bool names_page(std::string_view cell) {
  return has_word("page seite pagina hoja folio", first_word(cell));
}

} // namespace

bool names_sample(std::string_view cell) {
  return names_samples(first_word(cell));
}

void WordsOfRows::check_among(const Source &source) const {
  if (among_ != nullptr)
    source.refuse(among_->line,
                  fmt::format("{} is among the rows of the table, and is no sieve, pan, loss or total: write "
                              "it above or below the table, or leave it out",
                              in_quotes(among_->first())));
}

void WordsOfRows::check_sieve(const CellRow &row, std::string_view size, const Source &source) const {
  if (!below_.empty())
    source.refuse(row.line,
                  fmt::format("the row of {} is below {}, which may begin another table: leave out what is "
                              "none of the curve; {}",
                              in_quotes(size), in_quotes(below_.back()->first()), split_remedy()));
}

std::string_view WordsOfRows::between_tables() const {
  if (among_ != nullptr && !names_page(among_->first()))
    return among_->first();
  return below_.empty() ? std::string_view() : below_.back()->first();
}

bool WordsOfRows::are_of_others() const {
  const auto is_of_other = [](const CellRow *row) {
    const std::string_view words = row->first();
    return speaks_of_sample(words) || speaks_of_splitting(words) || speaks_of_part(words);
  };
  return (among_ != nullptr && is_of_other(among_)) || std::any_of(below_.begin(), below_.end(), is_of_other);
}

} // namespace mdm
