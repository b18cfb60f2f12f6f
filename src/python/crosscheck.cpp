#include "ask/option_values.hpp"
#include "crosscheck/other_answer.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"

#include <mdm/crosscheck/crosscheck.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mdm::python {
namespace {

/// Judges one solver's answers to one gradation.
class Judge {
public:
  Judge(const Gradation &g, const std::optional<std::string> &max_steps)
      : problem_(g, limits_of_steps(max_steps)) {}

  /// \param answer  a line of JSON as `mdm crosscheck` reads it
  py::tuple judge(const std::string &answer, const std::string &size_tolerance) const {
    const Rational tolerance = not_negative("size-tolerance", size_tolerance);
    if (tolerance >= 1)
      throw InputError("size_tolerance: " + in_quotes(size_tolerance) +
                       " is not below 1: it is a part of the size, such as 1e-9");
    CrosscheckRow row;
    {
      const py::gil_scoped_release unlocked;
      row = problem_.judge(json_answer(answer), tolerance);
    }
    return as_tuple(row);
  }

  /// The row of a solver that failed.
  py::tuple failed(const std::string &verdict, const std::string &reason) const {
    OtherAnswer none =
        failed_answer(problem_.gradation().id(), answer_verdict_named(verdict).value(), reason);
    return as_tuple(problem_.judge(none, 0));
  }

private:
  static Limits limits_of_steps(const std::optional<std::string> &max_steps) {
    Limits limits;
    if (max_steps)
      limits.max_steps = natural64("max-steps", *max_steps);
    return limits;
  }

  static py::tuple as_tuple(const CrosscheckRow &row) {
    const auto text = [](const std::optional<Rational> &r) {
      return r ? std::optional(to_string(*r)) : std::nullopt;
    };
    return py::make_tuple(
        row.id, std::string(name(row.verdict)), row.particles ? int_of(*row.particles) : py::none(),
        row.minimum ? int_of(*row.minimum) : py::none(), text(row.ratio), text(row.max_error), row.reason);
  }

  Crosscheck problem_;
};

} // namespace

void add_crosscheck(py::module_ &module) {
  py::class_<Judge>(module, "Judge")
      .def(py::init<const Gradation &, const std::optional<std::string> &>(),
           py::call_guard<py::gil_scoped_release>())
      .def("judge", &Judge::judge)
      .def("failed", &Judge::failed);
}

} // namespace mdm::python
