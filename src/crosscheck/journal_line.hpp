#pragma once
/// \file
/// The labels of a line of a journal of answers.

#include "crosscheck/other_answer.hpp"

#include <mdm/gradation/gradation.hpp>

namespace mdm {

/// The labels of an answer in a journal.
namespace journal_label {
inline constexpr const char *solver = "solver";       ///< its command
inline constexpr const char *line = "line";           ///< of the suite
inline constexpr const char *gradation = "gradation"; ///< digest() of what the solver was asked
} // namespace journal_label

/// A gradation in 64 bits (FNV-1a of its JSON, hexadecimal): what a solver is asked.
std::string digest(const Gradation &g);

/// The digest of what was asked, of an answer with the labels of a journal; nothing for other answers.
std::optional<std::string> asked_digest(const OtherAnswer &answer);

} // namespace mdm
