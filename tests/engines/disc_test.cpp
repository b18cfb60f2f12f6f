// Models of discs, whose results discs.py, with numpy, finds anew from the discs that the engine left.

#include "support.hpp"

namespace disc_test {

using namespace cli_test;

namespace {

const std::string two_classes = "size_mm,mass\n0.3,1\n0.4,1\n0.6,0\n";

Arguments of_discs(const Arguments &more = {}) {
  Arguments all{"--dimension", "2", "--law", "power:2", "--at-least", "300", "--young", "1e7"};
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

std::string end_of(const Outcome &outcome) {
  const std::string text = outcome.out + outcome.err;
  return text.substr(text.size() < 3000 ? 0 : text.size() - 3000);
}

/// Runs the model and holds its result against its discs, and these against the gradation.
void check_result(const Model &model, const std::string &isostatic, const Arguments &more = {}) {
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  const TemporaryFolder folder;
  Arguments arguments{MDM_SOURCE_DIR "/tests/engines/discs.py", model.dump(),
                      folder.write("log", outcome.out), isostatic};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome check = Process("/usr/bin/python3", arguments).end();
  INFO(check.out << check.err);
  CHECK(check.exit_code == 0);
  model.check_grains({"--law", "power:2", "--at-least", "300"});
}

} // namespace

TEST_CASE("discs at rest between walls are a result, with what it is", "[engines]") {
  for (const Engine &engine : {lammps, yade})
    if (is_there(engine))
      check_result(Model(engine, two_classes, of_discs()), "3");
}

TEST_CASE("discs without friction have four contacts each", "[engines]") {
  if (is_there(lammps))
    check_result(Model(lammps, two_classes, of_discs({"--friction", "0"})), "4");
}

TEST_CASE("a lid compacts discs to a pressure", "[engines]") {
  for (const Engine &engine : {lammps, yade})
    if (is_there(engine))
      check_result(Model(engine, two_classes, of_discs({"--stress", "1000"})), "3", {"--stress", "1000"});
}

TEST_CASE("falling discs are no bed", "[engines]") {
  for (const Engine &engine : {lammps, yade}) {
    if (!is_there(engine))
      continue;
    const Model model(engine, two_classes, of_discs({"--steps", "300"}));
    const Outcome outcome = model.run();
    INFO(end_of(outcome));
    CHECK(outcome.exit_code == 1);
    CHECK((outcome.out + outcome.err).find("STOP: not at rest after ") != std::string::npos);
    CHECK_FALSE(model.has_dump());
  }
}

} // namespace disc_test
