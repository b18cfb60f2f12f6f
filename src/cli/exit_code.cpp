#include "cli/exit_code.hpp"

namespace mdm::cli {

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

} // namespace mdm::cli
