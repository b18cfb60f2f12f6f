#pragma once
/// \file
/// The same work on many things, by several threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <map>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace mdm {

/// Calls work(0), ..., work(n - 1), each once, in any order; throws what one of them threw, at the end. By
/// fewer threads where the system has no more.
template <class Work>
void in_parallel(std::size_t n, unsigned threads, const Work &work) {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (std::size_t i = next++; i < n; i = next++)
        work(i);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      failure = std::current_exception();
      next = n;
    }
  };
  std::vector<std::thread> helpers;
  try {
    for (unsigned t = 1; t < std::min<std::size_t>(threads, n); ++t)
      helpers.emplace_back(run);
  } catch (const std::system_error &) {
    // No more are to be had, as in WebAssembly: those that there are do it.
  }
  run();
  for (std::thread &helper : helpers)
    helper.join();
  if (failure)
    std::rethrow_exception(failure);
}

/// Calls give(make(0)), ..., give(make(n - 1)) in this order, one at a time, while several threads make them,
/// up to the first that was not begun as is_enough() held; throws what one of them threw, at the end.
/// \return how many were given
template <class Made, class Make, class Give, class IsEnough>
std::size_t in_order(std::size_t n, unsigned threads, const Make &make, const Give &give,
                     const IsEnough &is_enough) {
  std::mutex mutex;
  std::map<std::size_t, Made> waiting; // for what comes before them
  std::size_t given = 0;
  in_parallel(n, threads, [&](std::size_t i) {
    if (is_enough())
      return;
    Made made = make(i);
    const std::lock_guard lock(mutex);
    waiting.emplace(i, std::move(made));
    for (auto next = waiting.begin(); next != waiting.end() && next->first == given;
         next = waiting.erase(next), ++given)
      give(next->second);
  });
  return given;
}

} // namespace mdm
