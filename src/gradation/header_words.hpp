#pragma once
/// \file
/// The words that laboratories and instruments put above the columns of a gradation, in their languages.

#include <optional>
#include <string>
#include <string_view>

namespace mdm {

/// What a column holds, as its header says.
enum class ColumnMeaning {
  size,       ///< openings or particle sizes
  sieve,      ///< sieves, by their names or by openings with units
  retained,   ///< what each sieve retains
  cumulative, ///< what it and all coarser sieves retain
  passing     ///< what passes it
};

/// What is behind a name in brackets, or a cell of units below it.
enum class ColumnUnit { none, mm, um, m, inch, phi, percent, fraction, mass };

/// True for units of length and phi.
bool is_of_sizes(ColumnUnit unit);

struct HeaderMeaning {
  ColumnMeaning meaning;
  ColumnUnit unit = ColumnUnit::none;
};

/// The meaning of a header such as `Siebweite [mm]`, `% passing` or `Rückstand in g`, where the table of
/// words has it; letter case, accents and punctuation do not count.
std::optional<HeaderMeaning> header_meaning(std::string_view header);

/// The unit that a header names beside other words, whether these are known or not: `Korngröße d [mm]`.
ColumnUnit unit_in_header(std::string_view header);

/// The unit that a cell names by itself: `mm`, `[µm]`, `(%)`, `M.-%`, `g`.
ColumnUnit unit_of_words(std::string_view words);

/// True for the row of what passes the finest sieve: `pan`, `Schale`, `Boden`.
bool is_pan_word(std::string_view cell);

/// True for the row of a sum: `Total`, `Summe`.
bool is_total_word(std::string_view cell);

/// A header or cell in the one spelling that is compared: small letters without accents, words with one space
/// between them.
std::string plain_words(std::string_view text);

} // namespace mdm
