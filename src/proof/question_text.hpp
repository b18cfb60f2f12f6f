#pragma once
/// \file
/// The lines of a certificate that say what was asked of a gradation.

#include <mdm/match/question.hpp>

#include <string>

namespace mdm {

/// All lines of a certificate that say what was asked of g, but those of `pi`.
/// \throws InputError as tolerance_lines()
std::string asked_lines(const Gradation &g, const Question &question);

/// The lines from `law` to `size-factor`.
std::string law_and_openings_lines(const Question &question);

/// The lines from `retained` to `band`, and what they count in the format's limits.
struct ToleranceLines {
  std::string text;
  std::size_t longest = 1; ///< bits of the longest number
  std::size_t bands = 0;   ///< lines of a band, or rows of its file
};

/// \param g  with the question's changes
/// \throws InputError if g does not have what a tolerance needs
ToleranceLines tolerance_lines(const Question &question, const Gradation &g);

} // namespace mdm
