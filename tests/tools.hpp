#pragma once
/// \file
/// Programs of others that some tests run.

#include "catch.hpp"

#include <cstdlib>
#include <string>

namespace mdm_test {

/// True if the program is on PATH. Else says which Debian package has it: a failure where MDM_REQUIRE_TOOLS
/// is set in the environment, as tests/run sets it, and a warning otherwise.
inline bool has_tool(const std::string &program, const std::string &package) {
  if (std::system(("command -v " + program + " >/dev/null").c_str()) == 0)
    return true;
  const std::string what = program + " is not installed (Debian: " + package + ")";
  if (std::getenv("MDM_REQUIRE_TOOLS") != nullptr)
    FAIL(what);
  WARN("not tested: " << what);
  return false;
}

} // namespace mdm_test
