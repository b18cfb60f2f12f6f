#include "files/interrupt.hpp"

#include <atomic>
#include <csignal>

namespace mdm {
namespace {

std::atomic<int> pressed = 0; // of bool not each machine has one without a lock
static_assert(std::atomic<int>::is_always_lock_free);
struct sigaction replaced_action {};

void note(int signal) {
  pressed = 1;
  sigaction(signal, &replaced_action, nullptr);
}

} // namespace

Interrupt::Interrupt() {
  pressed = 0;
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
  return pressed != 0;
}

} // namespace mdm
