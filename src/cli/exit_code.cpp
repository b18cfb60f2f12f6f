#include "cli/exit_code.hpp"

namespace mdm::cli {

int worse_exit(int a, int b) {
  for (const int worst : {Exit::bad_input, Exit::limited, Exit::negative})
    if (a == worst || b == worst)
      return worst;
  return Exit::done;
}

Exit exit_code(Status status) {
  switch (status) {
  case Status::optimal:
    return Exit::done;
  case Status::none:
    return Exit::negative;
  default:
    return Exit::limited;
  }
}

Exit exit_code(const Match &match, const Limits &limits) {
  const bool is_close =
      match.status == Status::feasible && limits.is_close(*match.particles(), match.lower_bound);
  return is_close ? Exit::done : exit_code(match.status);
}

} // namespace mdm::cli
