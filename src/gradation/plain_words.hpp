#pragma once
/// \file
/// The one spelling in which words of a table are compared.

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// The words of a header or cell in small letters without accents; what is no letter or digit is a space
/// between them, but `%` is the word percent and `+` the word plus.
std::vector<std::string> words_of(std::string_view text);

/// Words with one space between them.
std::string joined(const std::vector<std::string> &words);

/// The words of `text`, joined.
std::string plain_words(std::string_view text);

/// The words of a list, which has one space between them.
std::vector<std::string_view> listed_words(std::string_view list);

/// True where `word` is one of `list`, which has spaces between its words.
bool has_word(std::string_view list, std::string_view word);

/// True where one of the words is one of `list`.
bool has_any_word(std::string_view list, const std::vector<std::string> &words);

/// True where there are words, and each is one of `list`.
bool has_only_words(std::string_view list, const std::vector<std::string> &words);

/// True where one of the words is one of `first`, and the next one of `second`.
bool has_two_words(std::string_view first, std::string_view second, const std::vector<std::string> &words);

} // namespace mdm
