#pragma once
/// \file
/// The words that laboratories and instruments put above the columns of a gradation, in their languages.

#include <mdm/gradation/size_unit.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

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

/// The unit of length that it is; nothing for all others.
std::optional<SizeUnit> length_of(ColumnUnit unit);
/// True for units of length and phi.
bool is_of_sizes(ColumnUnit unit);

struct HeaderMeaning {
  ColumnMeaning meaning;
  ColumnUnit unit = ColumnUnit::none;
  bool is_individual = false; ///< the header says that no coarser sieve is counted too
  bool is_symbol =
      false; ///< the header is `Ri`: the mass on each sieve, in older French sheets the cumulative one
  bool is_unclear = false; ///< of what is retained: all coarser sieves may be counted too
};

/// True for the meaning of a column of sizes or of names of sieves.
bool holds_sizes(const HeaderMeaning &meaning);

/// The meaning of a header such as `Siebweite [mm]`, `% passing` or `Rückstand in g`, where the table of
/// words has it; letter case, accents and punctuation do not count.
std::optional<HeaderMeaning> header_meaning(std::string_view header);

/// The unit that a header names beside other words, whether these are known or not: `Korngröße d [mm]`.
ColumnUnit unit_in_header(std::string_view header);

/// The words of a header without its unit, which may be `unit` or none; empty where it is another.
std::vector<std::string> words_in(std::string_view header, ColumnUnit unit);

/// The unit that a cell names by itself: `mm`, `[µm]`, `(%)`, `M.-%`, `g`.
ColumnUnit unit_of_words(std::string_view words);

/// True where a header or cell speaks of kilograms: other masses are in g.
bool names_kilograms(std::string_view text);
/// True where it speaks of pounds, ounces, milligrams or tonnes, which are not read.
bool names_other_mass(std::string_view text);

} // namespace mdm
