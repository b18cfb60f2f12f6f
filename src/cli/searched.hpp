#pragma once
/// \file
/// A search with its progress on a terminal, which Ctrl-C ends with what is known.

#include "ask/asked_search.hpp"

namespace mdm::cli {

/// The answer, or what is known of it when Ctrl-C is pressed, which its notes say.
Found searched(const AskedSearch &search, const Gradation &g, const Question &question, bool quiet);

/// True if Ctrl-C left something of the answer open.
bool was_interrupted(const Match &found);
/// Says so in the notes of the match.
void note_interrupt(Match &found);

} // namespace mdm::cli
