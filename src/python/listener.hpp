#pragma once
/// \file
/// Python's word in a search that runs without its lock.

#include <mdm/match/solve.hpp>

#include <pybind11/pybind11.h>

#include <atomic>
#include <mutex>
#include <optional>

namespace mdm::python {

/// Asks Python ten times a second whether to go on: a signal such as Ctrl-C, or an exception of the caller's
/// function, ends the search as a limit does. Several searches may share a listener; all end then. Made,
/// asked for its error and destroyed with the lock held.
class Listener {
public:
  /// \param function  called with (steps, lower bound, particles or None); None: signals alone
  explicit Listener(pybind11::object function) : function_(std::move(function)) {}

  /// For a search on any thread.
  ProgressCall call();
  /// Looks for signals; takes the lock. \return false if the search is to end
  bool goes_on();
  /// Ends the search without an exception.
  void stop() { stopped_ = true; }
  bool is_stopped() const { return stopped_; }
  /// The exception that ended the search, or None.
  pybind11::object error() const;
  /// Throws that exception, if there is one.
  void rethrow();

private:
  bool ask(const Progress &progress);
  void keep_error();

  pybind11::object function_;
  std::atomic<bool> stopped_ = false;
  std::optional<pybind11::error_already_set> error_; ///< guarded by Python's lock
};

} // namespace mdm::python
