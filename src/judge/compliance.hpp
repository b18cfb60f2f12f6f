#pragma once
/// \file
/// What is certain of several requirements, and how it is said.

#include <mdm/judge/specification.hpp>

namespace mdm {

/// For people: `PASS`, `FAIL`, `HANGS on what the report does not tell`, `UNDECIDED: a limit of precision was
/// reached`.
std::string_view headline(Compliance verdict);

/// That of all requirements together: undecided, else fails, else hangs, else holds.
Compliance worst(const std::vector<Compliance> &verdicts);

} // namespace mdm
