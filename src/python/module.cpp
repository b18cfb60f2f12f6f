/// \file
/// The extension module exactmdm._core: what the library does, with numbers as texts and answers as JSON. The
/// package exactmdm makes Python's values of them.

#include "python/module.hpp"

#include "ask/option_table.hpp"
#include "text/option_name.hpp"
#include "text/versions.hpp"

#include <mdm/text/error.hpp>

namespace py = pybind11;

namespace {

/// InputError becomes the exception of that name of the package.
void translate(std::exception_ptr error) {
  try {
    if (error)
      std::rethrow_exception(error);
  } catch (const mdm::InputError &e) {
    const py::object type = py::module_::import("exactmdm.errors").attr("InputError");
    PyErr_SetObject(type.ptr(), py::str(e.what()).ptr());
  }
}

py::dict version_dict() {
  py::dict all;
  for (const auto &[library, version] : mdm::versions())
    all[py::str(library)] = py::str(version);
  return all;
}

} // namespace

PYBIND11_MODULE(_core, module) {
  mdm::spell_options(mdm::OptionSpelling::keyword);
  module.doc() = "The library behind exactmdm; use the package.";
  py::register_exception_translator(translate);
  module.def("versions", version_dict);
  module.def("option_table", mdm::option_table_json);
  mdm::python::add_gradation(module);
  mdm::python::add_match(module);
  mdm::python::add_spread(module);
  mdm::python::add_batch(module);
  mdm::python::add_check(module);
  mdm::python::add_verification(module);
  mdm::python::add_reports(module);
  mdm::python::add_crosscheck(module);
  mdm::python::add_suite(module);
}
