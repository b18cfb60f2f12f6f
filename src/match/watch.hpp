#pragma once
/// \file
/// The watch that ends a search from outside: the time, or the caller.

#include <mdm/match/solve.hpp>

#include <chrono>
#include <memory>

namespace mdm {

/// Looks at the clock for the searches of one call of solve(), and tells the caller what they know. Copies
/// share the caller's word. Cost of a look: nothing without a deadline and a caller, else a call of the
/// clock.
class Watch {
public:
  using Time = std::chrono::steady_clock::time_point;
  using Deadline = std::optional<Time>;
  /// Adds what a search knows.
  using Tell = std::function<void(Progress &)>;

  Watch() = default;
  explicit Watch(Deadline deadline, const ProgressCall &call = {});

  /// The same watch with another deadline.
  Watch until(Deadline deadline) const;
  /// The same watch inside a search: `tell` speaks first, then what this watch tells already, which may say
  /// it in terms of the whole question.
  Watch telling(Tell tell) const;

  /// True if the search is to end: after the deadline, or since the caller said so.
  bool ends() const { return (deadline_ || caller_) && look(); }
  /// True if the caller said so.
  bool is_stopped() const;

private:
  struct Caller {
    ProgressCall call;
    Time next;
    bool stopped = false;
  };
  bool look() const;

  Deadline deadline_;
  std::shared_ptr<Caller> caller_;
  Tell tell_;
};

} // namespace mdm
