#pragma once
/// \file
/// The progress of one search, shown on a terminal, and its end by Ctrl-C.

#include "files/interrupt.hpp"
#include "files/progress_line.hpp"

#include <mdm/match/solve.hpp>

#include <mutex>
#include <optional>

namespace mdm::cli {

/// Shows what a search knows while it goes on. The first Ctrl-C ends the search as a limit does.
class SearchProgress {
public:
  explicit SearchProgress(bool quiet);

  /// For SolveOptions::progress; this must outlive the search.
  ProgressCall call();

private:
  std::string text();

  std::mutex mutex_;
  std::optional<mdm::Progress> known_;
  Interrupt interrupt_;
  ProgressLine line_; // last: its thread calls text()
};

} // namespace mdm::cli
