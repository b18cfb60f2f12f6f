#include "match/watch.hpp"

namespace mdm {
namespace {

constexpr std::chrono::milliseconds between_calls{100};

} // namespace

Watch::Watch(Deadline deadline, const ProgressCall &call) : deadline_(deadline) {
  if (call)
    caller_ = std::make_shared<Caller>(Caller{call, std::chrono::steady_clock::now() + between_calls});
}

Watch Watch::until(Deadline deadline) const {
  Watch watch = *this;
  watch.deadline_ = deadline;
  return watch;
}

Watch Watch::telling(Tell tell) const {
  Watch watch = *this;
  if (!caller_)
    return watch;
  if (tell_)
    watch.tell_ = [first = std::move(tell), then = tell_](Progress &known) {
      first(known);
      then(known);
    };
  else
    watch.tell_ = std::move(tell);
  return watch;
}

bool Watch::is_stopped() const {
  return caller_ && caller_->stopped;
}

bool Watch::look() const {
  if (is_stopped())
    return true;
  const Time now = std::chrono::steady_clock::now();
  if (deadline_ && now > *deadline_)
    return true;
  if (!caller_ || now < caller_->next)
    return false;
  Progress known;
  if (tell_)
    tell_(known);
  caller_->stopped = !caller_->call(known);
  caller_->next = std::chrono::steady_clock::now() + between_calls;
  return caller_->stopped;
}

} // namespace mdm
