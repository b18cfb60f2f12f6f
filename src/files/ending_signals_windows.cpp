#include "files/ending_signals.hpp"

#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>

namespace mdm {
namespace {

using Action = void (*)();
std::array<std::atomic<Action>, 4> actions{};

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
  // SIGBREAK is of Ctrl-Break, and of a console that is closed.
  for (const int signal : {SIGINT, SIGTERM, SIGBREAK, SIGABRT})
    if (std::signal(signal, act_and_end) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

} // namespace mdm
