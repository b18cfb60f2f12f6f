#include "files/progress_line.hpp"

#include "files/standard_streams.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>

namespace mdm {

ProgressLine::ProgressLine(std::function<std::string()> text, bool quiet) : text_(std::move(text)) {
  if (!quiet && isatty(STDERR_FILENO) != 0)
    thread_ = std::thread(&ProgressLine::run, this);
}

ProgressLine::~ProgressLine() {
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  finished_.notify_one();
  if (thread_.joinable())
    thread_.join();
}

void ProgressLine::run() {
  using namespace std::chrono;
  const steady_clock::time_point start = steady_clock::now();
  bool shown = false;
  std::unique_lock lock(mutex_);
  for (milliseconds wait(2000); !finished_.wait_for(lock, wait, [this] { return done_; });
       wait = milliseconds(500)) {
    const auto seconds = duration_cast<std::chrono::seconds>(steady_clock::now() - start).count();
    tell(fmt::format("\r\x1b[K{}, {} s", text_(), seconds));
    shown = true;
  }
  if (shown)
    tell("\r\x1b[K");
}

} // namespace mdm
