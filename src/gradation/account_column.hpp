#pragma once
/// \file
/// A column of a sheet that speaks of mass, and what two of them say of one sample.

#include "gradation/header_words.hpp"
#include "gradation/printed_number.hpp"

#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// The numbers of a column that speaks of mass, percent and fractions as percent.
struct AccountColumn {
  std::string header;
  HeaderMeaning meaning;
  unsigned grams = 0; ///< in one of its unit; 0 of percent, and where that is not said
  /// One a sieve, from the coarsest to the finest; nothing where the cell is empty.
  std::vector<std::optional<PrintedNumber>> sieves;
  /// What passes the finest sieve, if the column says it: in the pan, washed out, or what is left of the
  /// whole.
  std::optional<PrintedNumber> below;

  bool is_share() const {
    return meaning.unit == ColumnUnit::percent || meaning.unit == ColumnUnit::fraction;
  }
  /// True for the masses or shares of the single sieves.
  bool is_retained() const { return meaning.meaning == ColumnMeaning::retained; }
  /// True for masses that are added up, those of the single sieves or cumulative ones.
  bool adds_masses() const { return !is_share() && meaning.meaning != ColumnMeaning::passing; }
  /// The numbers that sieves have, from the coarsest on.
  std::vector<Rational> numbers() const;
  /// What all sieves retain, the finest included; nothing where it is not known.
  std::optional<PrintedNumber> retained() const;
  /// The whole: 100 of shares that pass or are cumulative, else the sum; nothing where it is not known.
  std::optional<PrintedNumber> whole() const;
  /// What the sieves behind `first` up to `last` retain, the first sieve being behind 0; nothing where it is
  /// not known.
  std::optional<PrintedNumber> between(std::size_t first, std::size_t last) const;
  /// True where what is coarser and what is finer than the first `count` sieves can be told apart.
  bool is_station(std::size_t count) const;
  /// The percentage that passes a sieve, without regard to rounding; nothing where it is not known.
  std::optional<Rational> passing_percent(std::size_t sieve) const;
};

/// How the numbers of one column stand to those of another.
struct ColumnComparison {
  /// The sieve at which they differ by more than their rounding explains.
  std::optional<std::size_t> disagreement = {};
  /// The range of the first column's whole that makes the second column's shares of the first's masses;
  /// nothing where the second has no shares or they do not tell.
  std::optional<Interval> whole = {};
};

/// Compares what the sieves retain by both, where both say it. There must be one factor between the columns:
/// 1 where both have masses or both have shares.
ColumnComparison compare(const AccountColumn &first, const AccountColumn &second);

/// True where masses may have the shares of their own sum: between any two sieves that both columns tell
/// apart, the masses rounded as printed make no share that is out of the printed one's rounding. True also
/// where the sum is not known.
bool may_have_shares(const AccountColumn &masses, const AccountColumn &shares);

} // namespace mdm
