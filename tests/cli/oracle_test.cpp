// The answers to random small problems against an independent computation in Python.

#include "run.hpp"

#include <unistd.h>

namespace oracle_test {

using namespace cli_test;

namespace {

const char *const python = "/usr/bin/python3";

Outcome oracle(const Arguments &options) {
  Arguments arguments{"-B", std::string(MDM_SOURCE_DIR) + "/tests/cli/oracle.py", MDM_PROGRAM,
                      MDM_CHECK_PROGRAM};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return Process(python, arguments).end();
}

} // namespace

TEST_CASE("random problems have the answers of the oracle", "[cli]") {
  if (access(python, X_OK) != 0)
    return; // a bare system has none
  const Outcome outcome = oracle({"--seconds", "10", "--seed", "1"});
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == 0);
}

} // namespace oracle_test
