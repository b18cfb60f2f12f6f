#include "cli/exit_code.hpp"

namespace mdm::cli {

int worse_exit(int a, int b) {
  for (const int worst : {Exit::bad_input, Exit::limited, Exit::negative})
    if (a == worst || b == worst)
      return worst;
  return Exit::done;
}

Exit exit_code(Outcome outcome) {
  switch (outcome) {
  case Outcome::done:
    return Exit::done;
  case Outcome::negative:
    return Exit::negative;
  default:
    return Exit::limited;
  }
}

} // namespace mdm::cli
