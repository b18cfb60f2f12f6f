#include "files/signal_handlers.hpp"

#include <csignal>
#include <initializer_list>

namespace mdm {

void handle_ending_signals(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGABRT}) {
    struct sigaction before {};
    sigaction(signal, nullptr, &before);
    if (before.sa_handler != SIG_IGN) // nohup
      sigaction(signal, &action, nullptr);
  }
}

} // namespace mdm
