#include "gradation/number_shares.hpp"

#include "gradation/plain_words.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace mdm {

bool speaks_of_number_shares(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  const auto have = [&words](std::string_view list) {
    return std::any_of(words.begin(), words.end(),
                       [list](const std::string &w) { return has_word(list, w); });
  };
  return have("number anzahl nombre numero") &&
         have("distribution distributions distribucion distribuzione weighted weighting basis base "
              "anzahlverteilung verteilung");
}

void refuse_number_shares(const Cells &cells, std::size_t above, const Source &source) {
  for (std::size_t i = 0; i < above; ++i) {
    const CellRow &row = cells.rows[i];
    for (std::size_t c = 0; c < row.cells.size(); ++c)
      for (const std::string &text : {row.cells[c], row.cells[c] + " " + std::string(row.cell(c + 1))})
        if (speaks_of_number_shares(text))
          source.refuse(row.line, fmt::format("{} says that the shares are by number: {}", in_quotes(text),
                                              number_shares_remedy));
  }
}

} // namespace mdm
