#include "files/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace mdm {
namespace {

std::atomic<bool> pressed = false;
static_assert(std::atomic<bool>::is_always_lock_free);
struct sigaction replaced_action {};

void note(int signal) {
  pressed = true;
  sigaction(signal, &replaced_action, nullptr);
}

} // namespace

Interrupt::Interrupt() {
  pressed = false;
  sigaction(SIGINT, nullptr, &replaced_action);
  if (replaced_action.sa_handler == SIG_IGN)
    return;
  struct sigaction action {};
  action.sa_handler = note;
  sigaction(SIGINT, &action, nullptr);
}

Interrupt::~Interrupt() {
  sigaction(SIGINT, &replaced_action, nullptr);
}

bool Interrupt::was_pressed() {
  return pressed;
}

} // namespace mdm
