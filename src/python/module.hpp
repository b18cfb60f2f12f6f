#pragma once
/// \file
/// The parts of the extension module; each adds its types and functions.

#include <pybind11/pybind11.h>

namespace mdm::python {

void add_batch(pybind11::module_ &module);
void add_check(pybind11::module_ &module);
void add_crosscheck(pybind11::module_ &module);
void add_gradation(pybind11::module_ &module);
void add_match(pybind11::module_ &module);
void add_reports(pybind11::module_ &module);
void add_spread(pybind11::module_ &module);
void add_suite(pybind11::module_ &module);
void add_verification(pybind11::module_ &module);

} // namespace mdm::python
