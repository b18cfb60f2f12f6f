#include "python/listener.hpp"

#include "python/numbers.hpp"

namespace py = pybind11;

namespace mdm::python {

ProgressCall Listener::call() {
  return [this](const Progress &progress) { return !stopped_ && ask(progress); };
}

bool Listener::goes_on() {
  if (stopped_)
    return false;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() != 0)
    keep_error();
  return !stopped_;
}

bool Listener::ask(const Progress &progress) {
  if (!goes_on())
    return false;
  const py::gil_scoped_acquire lock;
  if (function_.is_none())
    return true;
  try {
    function_(progress.steps, int_of(progress.lower_bound),
              progress.particles ? int_of(*progress.particles) : py::none());
  } catch (const py::error_already_set &e) {
    error_ = e;
    stopped_ = true;
  }
  return !stopped_;
}

/// The first exception is the one that is told.
void Listener::keep_error() {
  const py::error_already_set e;
  if (!error_)
    error_ = e;
  stopped_ = true;
}

py::object Listener::error() const {
  return error_ ? py::reinterpret_borrow<py::object>(error_->value()) : py::none();
}

void Listener::rethrow() {
  if (error_)
    throw py::error_already_set(*error_);
}

} // namespace mdm::python
