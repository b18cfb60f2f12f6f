#pragma once
/// \file
/// A line on standard error while long work goes on.

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace mdm {

/// Shows `text()` and the seconds gone twice a second, from the second second on, if standard error is a
/// terminal; the line is removed at the end. `text` is called from another thread.
class ProgressLine {
public:
  ProgressLine(std::function<std::string()> text, bool quiet);
  ~ProgressLine();
  ProgressLine(const ProgressLine &) = delete;
  ProgressLine &operator=(const ProgressLine &) = delete;

private:
  void run();

  std::function<std::string()> text_;
  std::mutex mutex_;
  std::condition_variable finished_;
  bool done_ = false;
  std::thread thread_;
};

} // namespace mdm
