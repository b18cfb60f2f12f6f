#include "files/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace mdm {
namespace {

using Handler = void (*)(int);
std::atomic<int> pressed = 0;
std::atomic<Handler> replaced_handler = SIG_DFL;

void note(int signal) {
  pressed = 1;
  std::signal(signal, replaced_handler);
}

} // namespace

Interrupt::Interrupt() {
  pressed = 0;
  replaced_handler = std::signal(SIGINT, note);
  if (replaced_handler == SIG_IGN)
    std::signal(SIGINT, SIG_IGN);
}

Interrupt::~Interrupt() {
  std::signal(SIGINT, replaced_handler);
}

bool Interrupt::was_pressed() {
  return pressed != 0;
}

} // namespace mdm
