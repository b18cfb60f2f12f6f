#include "particles/comment_words.hpp"

#include "gradation/header_words.hpp"
#include "gradation/plain_words.hpp"
#include "particles/line_reader.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// True for a word that a unit follows.
bool announces_unit(std::string_view word) {
  return has_any_word("in unit units", words_of(word));
}

/// True for a unit that is no other word: `m` may be a mass, `u` a velocity, and `in` stand before anything.
bool is_clear(SizeUnit unit, std::string_view word) {
  return unit == SizeUnit::mm || (unit == SizeUnit::um && word.size() > 1) || word.front() == '(' ||
         word.front() == '[' || word.find_first_of("=_") != std::string_view::npos;
}

} // namespace

std::vector<std::string> words_behind_hash(std::string_view line) {
  std::vector<std::string_view> words;
  split_words(line.substr(std::min(line.find_first_not_of('#'), line.size())), words);
  return {words.begin(), words.end()};
}

std::optional<SizeUnit> unit_in_word(std::string_view word) {
  const std::size_t cut = word.find_last_of("=_");
  return length_of(unit_of_words(word.substr(cut == std::string_view::npos ? 0 : cut + 1)));
}

std::vector<SizeUnit> units_in_comment(const std::vector<std::string_view> &words) {
  std::vector<SizeUnit> units;
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const std::optional<SizeUnit> unit = unit_in_word(words[i]);
        unit && (is_clear(*unit, words[i]) || (i > 0 && announces_unit(words[i - 1]))))
      units.push_back(*unit);
  return units;
}

} // namespace mdm
