// The completions for shells.

#include "run.hpp"

#include <cstdlib>

namespace completion_test {

using namespace cli_test;

namespace {

std::string script(const std::string &shell) {
  const Outcome outcome = mdm({"completion", shell});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  return outcome.out;
}

/// What bash offers for the last of the words.
std::string offered(const TemporaryFolder &folder, const std::string &words, int last) {
  const std::string run = "source '" + (folder / "mdm") + "'; COMP_WORDS=(" + words +
                          "); COMP_CWORD=" + std::to_string(last) + "; _mdm; echo \"${COMPREPLY[*]}\"";
  return Process("/bin/bash", {"-c", run}).end().out;
}

bool is_there(const std::string &program) {
  return std::filesystem::exists("/usr/bin/" + program) || std::filesystem::exists("/bin/" + program);
}

} // namespace

TEST_CASE("bash completes commands, options and values that are listed", "[cli]") {
  const TemporaryFolder folder;
  folder.write("mdm", script("bash"));
  CHECK(offered(folder, "mdm so", 1) == "solve\n");
  CHECK(offered(folder, "mdm help trade", 2) == "tradeoff\n");
  CHECK(offered(folder, "mdm solve --tol", 2) == "--tolerance\n");
  CHECK(offered(folder, "mdm solve sand.csv --format ''", 4) == "text json csv\n");
  CHECK(offered(folder, "mdm pack --rule l", 3) == "lowest\n");
  CHECK(offered(folder, "mdm solve sa", 2) == "\n"); // a file: bash's own completion
}

TEST_CASE("zsh and fish take their completions", "[cli]") {
  const TemporaryFolder folder;
  for (const std::string shell : {"zsh", "fish"}) {
    const std::string file = folder.write("completions." + shell, script(shell));
    if (!is_there(shell)) {
      CHECK(std::getenv("MDM_REQUIRE_TOOLS") == nullptr);
      continue;
    }
    const Outcome checked = Process("/usr/bin/" + shell, {"-n", file}).end();
    INFO(checked.err);
    CHECK(checked.exit_code == 0);
  }
}

TEST_CASE("a shell that is not known is refused", "[cli]") {
  check_refused(mdm({"completion", "tcsh"}), "'tcsh' is not in {bash,zsh,fish}");
  check_refused(mdm({"completion"}), "SHELL is required");
}

} // namespace completion_test
