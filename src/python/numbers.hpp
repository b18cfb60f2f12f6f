#pragma once
/// \file
/// Numbers between Python and the library: texts, so that none of them is rounded.

#include <mdm/number/rational.hpp>

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace mdm::python {

/// The value of a decimal or of a fraction `p/q`.
/// \throws InputError if `text` is neither
Rational rational_of(const std::string &text);
/// The values of a list of such texts; errors name it and the place.
std::vector<Rational> rationals_of(const std::string &name, const std::vector<std::string> &texts);

/// `p/q` or `p`, one a number.
std::vector<std::string> texts_of(const std::vector<Rational> &numbers);

/// Python's int.
pybind11::object int_of(const Integer &n);

} // namespace mdm::python
