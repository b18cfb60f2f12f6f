#include "cli/searched.hpp"

#include "cli/search_progress.hpp"
#include "files/interrupt.hpp"

namespace mdm::cli {

Found searched(const AskedSearch &search, const Gradation &g, const Question &question, bool quiet) {
  SearchProgress progress(quiet);
  Found found = search.ask(g, question, progress.call());
  if (Interrupt::was_pressed())
    note_stopped(found.match);
  return found;
}

} // namespace mdm::cli
