#include "gradation/plain_words.hpp"

#include "gradation/plain_spelling.hpp"
#include "text/lines.hpp"

#include <algorithm>
#include <array>

namespace mdm {
namespace {

/// Letters with accents, and signs that are words.
constexpr std::array letters = {
    Spelling{"ä", "ae"},         Spelling{"Ä", "ae"},       Spelling{"ö", "oe"},
    Spelling{"Ö", "oe"},         Spelling{"ü", "ue"},       Spelling{"Ü", "ue"},
    Spelling{"ß", "ss"},         Spelling{"é", "e"},        Spelling{"É", "e"},
    Spelling{"è", "e"},          Spelling{"È", "e"},        Spelling{"ê", "e"},
    Spelling{"à", "a"},          Spelling{"á", "a"},        Spelling{"Á", "a"},
    Spelling{"í", "i"},          Spelling{"Í", "i"},        Spelling{"ì", "i"},
    Spelling{"ó", "o"},          Spelling{"Ó", "o"},        Spelling{"ò", "o"},
    Spelling{"ú", "u"},          Spelling{"Ú", "u"},        Spelling{"ù", "u"},
    Spelling{"ñ", "n"},          Spelling{"Ñ", "n"},        Spelling{"ç", "c"},
    Spelling{"\u00B5", "u"},     Spelling{"\u03BC", "u"},   Spelling{"\u03C6", "phi"},
    Spelling{"\u03A6", "phi"},   Spelling{"\u00A0", " "},   Spelling{"\u202F", " "},
    Spelling{"°", " "},          Spelling{"º", " "},        Spelling{"№", "no "},
    Spelling{"%", " percent "},  Spelling{"+", " plus "},   Spelling{"\u03A3", " sum "},
    Spelling{"\u2211", " sum "}, Spelling{"\u00D7", " x "},
};

/// True for what is a part of a word: letters, digits, and characters beyond ASCII.
bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || is_digit(c) || static_cast<unsigned char>(c) >= 0x80;
}

} // namespace

std::vector<std::string> words_of(std::string_view text) {
  std::string plain = spelled_plainly(text, letters);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return !is_of_word(c); }, ' ');
  std::vector<std::string> words;
  for (std::size_t from = 0; (from = plain.find_first_not_of(' ', from)) < plain.size();) {
    const std::size_t to = std::min(plain.find(' ', from), plain.size());
    words.push_back(plain.substr(from, to - from));
    from = to;
  }
  return words;
}

std::string joined(const std::vector<std::string> &words) {
  std::string text;
  for (const std::string &word : words)
    text += (text.empty() ? "" : " ") + word;
  return text;
}

std::string plain_words(std::string_view text) {
  return joined(words_of(text));
}

std::vector<std::string_view> listed_words(std::string_view list) {
  std::vector<std::string_view> words;
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t to = std::min(list.find(' ', from), list.size());
    words.push_back(list.substr(from, to - from));
    from = to + 1;
  }
  return words;
}

bool has_word(std::string_view list, std::string_view word) {
  if (word.empty())
    return false;
  for (std::size_t at = list.find(word); at != std::string_view::npos; at = list.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || list[at - 1] == ' ') && (end == list.size() || list[end] == ' '))
      return true;
  }
  return false;
}

bool has_any_word(std::string_view list, const std::vector<std::string> &words) {
  return std::any_of(words.begin(), words.end(),
                     [list](const std::string &word) { return has_word(list, word); });
}

bool has_only_words(std::string_view list, const std::vector<std::string> &words) {
  return !words.empty() && std::all_of(words.begin(), words.end(),
                                       [list](const std::string &word) { return has_word(list, word); });
}

bool has_two_words(std::string_view first, std::string_view second, const std::vector<std::string> &words) {
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (has_word(first, words[i]) && has_word(second, words[i + 1]))
      return true;
  return false;
}

} // namespace mdm
