#pragma once
/// \file
/// What the words of a header say together, unit and percent apart.

#include "gradation/header_words.hpp"

#include <string_view>
#include <vector>

namespace mdm {

struct WordsMeaning {
  ColumnMeaning meaning;
  bool is_individual = false; ///< the words say that no coarser sieve is counted too
  bool is_unclear = false;    ///< of what is retained: all coarser sieves may be counted too (French: refus)
};

/// The meaning of words as words_of gives them; nothing where one of them is not known, or where together
/// they may mean two things but for is_unclear. `has_length` is true where the header also names a unit of
/// length.
std::optional<WordsMeaning> meaning_of_words(std::vector<std::string> words, bool has_length);

/// True for a word that says of values that they are sums, such as `cumulative`.
bool is_word_of_sums(std::string_view word);

/// True for a text with such a word.
bool speaks_of_sums(std::string_view text);

} // namespace mdm
