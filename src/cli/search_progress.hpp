#pragma once
/// \file
/// The progress of one search, shown on a terminal, and its end by Ctrl-C.

#include "ask/asked_search.hpp"
#include "files/interrupt.hpp"
#include "files/progress_line.hpp"

#include <mutex>
#include <optional>

namespace mdm::cli {

/// Shows what a search knows while it goes on. The first Ctrl-C ends the search as a limit does.
class SearchProgress {
public:
  explicit SearchProgress(bool quiet);

  /// For SolveOptions::progress; this must outlive the search.
  ProgressCall call();
  /// True if Ctrl-C left something of the answer open.
  static bool was_interrupted(const Match &found);
  /// Says so in the notes of the match.
  static void note_interrupt(Match &found);

private:
  std::string text();

  std::mutex mutex_;
  std::optional<mdm::Progress> known_;
  Interrupt interrupt_;
  ProgressLine line_; // last: its thread calls text()
};

/// The answer, or what is known of it when Ctrl-C is pressed, which its notes say.
Found searched(const AskedSearch &search, const Gradation &g, const Question &question, bool quiet);

} // namespace mdm::cli
