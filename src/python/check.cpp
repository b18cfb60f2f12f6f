#include "python/module.hpp"

#include <mdm/checker.hpp>

#include <array>

namespace py = pybind11;

namespace mdm::python {
namespace {

/// `accepted`, `refused` or `malformed`, what was proved, and why not.
py::tuple check(const std::string &gradation, const std::string &gradation_name, bool is_line,
                const std::string &certificate, const std::string &certificate_name) {
  static constexpr std::array<const char *, 3> codes = {"accepted", "refused", "malformed"};
  checker::Verdict verdict{};
  {
    const py::gil_scoped_release unlocked;
    verdict = checker::check({gradation_name, gradation, is_line}, {certificate_name, certificate});
  }
  return py::make_tuple(codes.at(static_cast<std::size_t>(verdict.code)), verdict.line, verdict.reason);
}

} // namespace

void add_check(py::module_ &module) {
  module.def("check", &check);
}

} // namespace mdm::python
