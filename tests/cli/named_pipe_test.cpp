// Files that are named pipes, as a shell's <(...) makes them: what is looked at of them is read all the same.

#include "run.hpp"

#include <sys/stat.h>

namespace named_pipe_test {

using namespace cli_test;

namespace {

const std::string sand = "size_mm,mass\n1,8\n2,64\n4,0\n";

/// Runs mdm with `words` in a shell, in which each $1, $2 is a pipe with the text.
Outcome with_pipes(const std::string &words, const std::vector<std::string> &texts) {
  const TemporaryFolder folder;
  std::string script;
  Arguments arguments = {"-c", "", MDM_PROGRAM};
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::string pipe = folder / ("pipe" + std::to_string(i));
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    script += "cat '" + folder.write("text" + std::to_string(i), texts[i]) + "' > '" + pipe + "' & ";
    arguments.push_back(pipe);
  }
  arguments[1] = script + "timeout 60 \"$0\" " + words;
  return Process("/bin/sh", arguments).end();
}

} // namespace

TEST_CASE("a gradation that comes through a named pipe is read as a file is", "[cli]") {
  const TemporaryFolder folder;
  const std::string file = folder.write("pipe0", sand);
  for (const std::string command : {"solve", "describe", "convert", "tradeoff", "published rounded"}) {
    const Outcome piped = with_pipes(command + " \"$1\"", {sand});
    INFO(command << ": " << piped.err);
    CHECK(piped.exit_code == 0);
    CHECK_FALSE(piped.out.empty());
  }
  CHECK(with_pipes("convert \"$1\"", {sand}).out == mdm({"convert", file}).out);
  CHECK(Process("/bin/sh", {"-c", "cat \"$1\" | \"$0\" convert /dev/stdin", MDM_PROGRAM, file}).end().out ==
        mdm({"convert", "-"}, sand).out);
}

TEST_CASE("a gradation and a sample come through pipes", "[cli]") {
  const Outcome verified = with_pipes("verify \"$1\" \"$2\"", {sand, "size_mm,quantity\n2,8\n4,8\n"});
  INFO(verified.err);
  CHECK(verified.exit_code == 0);
  CHECK(contains(verified.out, "matches exactly"));
}

TEST_CASE("beside a proof of a piped gradation stands the gradation", "[cli]") {
  const TemporaryFolder folder;
  const std::string proof = folder / "p";
  CHECK(with_pipes("solve \"$1\" --proof '" + proof + "'", {sand}).exit_code == 0);
  CHECK(mdm_check(proof + ".gradation.csv", proof).exit_code == 0);
}

TEST_CASE("the table of a law comes through a pipe", "[cli]") {
  const TemporaryFolder folder;
  const std::string law = "size_mm,particle_mass\n0,0\n1,1\n2,5\n4,30\n",
                    file = folder.write("sand.csv", sand), answer = folder / "a.json";
  REQUIRE(mdm({"solve", file, "--law", "table:" + folder.write("law.csv", law), "-o", answer}).exit_code ==
          0);
  const Outcome verified = with_pipes("verify '" + file + "' '" + answer + "' --law table:\"$1\"", {law});
  INFO(verified.err);
  CHECK(verified.exit_code == 0);
}

TEST_CASE("a pipe that is needed twice is refused, and nothing waits", "[cli]") {
  const Outcome outcome = with_pipes("describe \"$1\" \"$1\"", {sand});
  CHECK(outcome.exit_code == 2);
  CHECK(contains(outcome.err, "it is a pipe, which can be read once"));
}

} // namespace named_pipe_test
