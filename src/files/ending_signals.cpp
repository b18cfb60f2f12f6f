#include "files/ending_signals.hpp"

#include "files/signal_handlers.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace mdm {
namespace {

using Action = void (*)();
std::array<std::atomic<Action>, 4> actions{};
static_assert(std::atomic<Action>::is_always_lock_free);

void act_and_end(int signal) {
  for (const std::atomic<Action> &place : actions)
    if (const Action action = place.load())
      action();
  std::signal(signal, SIG_DFL);
  raise(signal);
}

} // namespace

void before_ending_signals(void (*action)()) {
  std::size_t i = 0;
  while (actions.at(i) != nullptr && actions.at(i) != action)
    ++i;
  actions.at(i) = action;
  handle_ending_signals(act_and_end);
}

} // namespace mdm
