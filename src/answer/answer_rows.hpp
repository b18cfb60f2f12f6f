#pragma once
/// \file
/// What the forms of an answer share: the texts of its classes.

#include "match/spread.hpp"

#include <mdm/match/match.hpp>

#include <string>
#include <vector>

namespace mdm {

/// One class of the gradation as all forms show it.
struct AnswerRow {
  std::size_t index = 0; ///< of the class, from 0
  std::string material;  ///< empty: it has no name
  std::string lower, upper, mass;
  std::string quantity;            ///< empty: no answer
  const Enclosure *size = nullptr; ///< nothing for an empty class

  std::string sizes() const { return "(" + lower + ", " + upper + "]"; }
};

/// A row for each class; its sizes are those of `m`, which must outlive it.
std::vector<AnswerRow> answer_rows(const Match &m);

/// Of one entry a row of the gradation but the last, or of none, those of the rows that begin a class.
template <class Entry>
std::vector<Entry> of_classes(const Gradation &g, const std::vector<Entry> &entries) {
  std::vector<Entry> of_classes;
  for (std::size_t j = 0; j < entries.size(); ++j)
    if (g.is_class(j))
      of_classes.push_back(entries[j]);
  return of_classes;
}

/// The margin, which has three digits; with an exponent if it is tiny.
std::string margin_text(const MatchScale &scale);

/// Calls take(size) for every particle of a class.
template <class Take>
void for_each_size(const ClassSpread &c, unsigned digits, Take take) {
  ClassSpread::Masses masses = c.masses();
  for (std::uint64_t i = 0; i < c.quantity(); ++i)
    take(c.size(masses.next(), digits));
}

} // namespace mdm
