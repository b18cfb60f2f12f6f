#pragma once
/// \file
/// What is certain of a requirement.

#include <string_view>
#include <vector>

namespace mdm {

/// A requirement holds for all curves that a report may mean, fails for all of them, or holds for some and
/// fails for others. Undecided where a limit of precision came first.
enum class Compliance { holds, fails, hangs, undecided };

/// `pass`, `fail`, `hangs`, `undecided`.
std::string_view name(Compliance verdict);

/// For people: `PASS`, `FAIL`, `HANGS on what the report does not tell`, `UNDECIDED: a limit of precision was
/// reached`.
std::string_view headline(Compliance verdict);

/// That of all requirements together: undecided, else fails, else hangs, else holds.
Compliance worst(const std::vector<Compliance> &verdicts);

} // namespace mdm
