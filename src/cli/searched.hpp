#pragma once
/// \file
/// A search with its progress on a terminal, which Ctrl-C ends with what is known.

#include "ask/asked_search.hpp"

namespace mdm::cli {

/// The answer, or what is known of it when Ctrl-C is pressed, which its notes say.
Found searched(const AskedSearch &search, const Gradation &g, const Question &question, bool quiet);

} // namespace mdm::cli
