#include "standard_streams.hpp"

#include <csignal>

namespace mdm::checker {

void settle_streams() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

} // namespace mdm::checker
