#include "cli/searched.hpp"

#include "cli/search_progress.hpp"
#include "files/interrupt.hpp"

namespace mdm::cli {

Found searched(const AskedSearch &search, const Gradation &g, const Question &question, bool quiet) {
  SearchProgress progress(quiet);
  Found found = search.ask(g, question, progress.call());
  note_interrupt(found.match);
  return found;
}

bool was_interrupted(const Match &found) {
  const bool is_open = !found.complete || (found.budget && !found.budget->is_decided);
  return is_open && Interrupt::was_pressed();
}

void note_interrupt(Match &found) {
  if (was_interrupted(found))
    found.notes.push_back("the search was interrupted");
}

} // namespace mdm::cli
