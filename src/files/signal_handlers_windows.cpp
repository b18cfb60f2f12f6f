#include "files/signal_handlers.hpp"

#include <csignal>
#include <initializer_list>

namespace mdm {

void handle_ending_signals(void (*handler)(int)) {
  // SIGBREAK is of Ctrl-Break, and of a console that is closed.
  for (const int signal : {SIGINT, SIGTERM, SIGBREAK, SIGABRT})
    if (std::signal(signal, handler) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

} // namespace mdm
