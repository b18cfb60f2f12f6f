#include "sets/suite.hpp"

#include "python/module.hpp"

namespace py = pybind11;

namespace mdm::python {

void add_suite(py::module_ &module) {
  py::class_<Suite>(module, "Suite")
      .def(py::init<const std::string &, const std::string &>())
      .def("line", &Suite::line, py::call_guard<py::gil_scoped_release>());
}

} // namespace mdm::python
