// What models say of their grains at the end: at rest or not, jammed or not, and with the friction that was
// asked for. state.py, with numpy, finds it anew from the grains that the engine left.

#include "support.hpp"

namespace state_test {

using namespace cli_test;

namespace {

std::string c778() {
  return read_file(example("c778-graded-sand"));
}

std::string end_of(const Outcome &outcome) {
  const std::string text = outcome.out + outcome.err;
  return text.substr(text.size() < 3000 ? 0 : text.size() - 3000);
}

bool says(const Outcome &outcome, const std::string &words) {
  return (outcome.out + outcome.err).find(words) != std::string::npos;
}

Arguments with(Arguments arguments, const Arguments &more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// Runs the model and holds its result against its grains.
void check_result(const Model &model, const std::string &young, const Arguments &more) {
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  REQUIRE(outcome.exit_code == 0);
  const TemporaryFolder folder;
  const std::string log = folder.write("log", outcome.out);
  const Arguments check_of{MDM_SOURCE_DIR "/tests/engines/state.py", model.dump(), log, young, "0.25"};
  const Outcome check = Process("/usr/bin/python3", with(check_of, more)).end();
  INFO(check.out << check.err);
  CHECK(check.exit_code == 0);
}

/// Exit code 1, the message, and no dump.
void check_stops(const Model &model, const std::string &message) {
  const Outcome outcome = model.run();
  INFO(end_of(outcome));
  CHECK(outcome.exit_code == 1);
  CHECK(says(outcome, message));
  CHECK(!says(outcome, "\nRESULT "));
  CHECK(!model.has_dump());
}

const Arguments cell{"--periodic", "--at-least", "300"};

} // namespace

TEST_CASE("a periodic box that has its pressure is a result, with what it is", "[engines]") {
  for (const Engine &engine : {lammps, yade}) {
    if (!is_there(engine))
      continue;
    const Model model(engine, c778(), with(cell, {"--stress", "100000"}));
    check_result(model, "2e8", {});
  }
}

TEST_CASE("a gas in a periodic box is no specimen, and the void ratio that is one is said", "[engines]") {
  for (const Engine &engine : {lammps, yade})
    if (is_there(engine))
      check_stops(Model(engine, c778(), with(cell, {"--void-ratio", "0.7"})), "they jam at void ratio 0.6");
}

TEST_CASE("a gas is a result where it is asked for", "[engines]") {
  for (const Engine &engine : {lammps, yade})
    if (is_there(engine))
      check_result(Model(engine, c778(), with(cell, {"--void-ratio", "0.9", "--unjammed"})), "5e6",
                   {"--unjammed"});
}

TEST_CASE("a bed at rest is a result, with what it is", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade})
    if (is_there(engine))
      check_result(Model(engine, c778(), {"--start", "deposit", "--at-least", "300"}), "5e6",
                   {"--wall", "box"});
}

TEST_CASE("falling grains are no bed", "[engines]") {
  for (const Engine &engine : {liggghts, lammps, yade}) {
    if (!is_there(engine))
      continue;
    const Model model(engine, c778(), {"--steps", "300"});
    check_stops(model, "STOP: not at rest after ");
    model.replace(engine.model, engine.name == "yade" ? "unjammed = False" : "unjammed index 0",
                  engine.name == "yade" ? "unjammed = True" : "unjammed index 1");
    CHECK(model.run().exit_code == 0);
    CHECK(model.has_dump());
  }
}

TEST_CASE("a plain bed has the friction and the restitution of its material", "[engines]") {
  const auto dump = [](const Engine &engine, const std::string &friction, const std::string &restitution) {
    const TemporaryFolder folder;
    std::string rows = "class,friction,restitution\n";
    for (int i = 1; i <= 5; ++i)
      rows += std::to_string(i) + "," + friction + "," + restitution + "\n";
    const Model model(engine, c778(),
                      {"--start", "deposit", "--material", folder.write("material.csv", rows), "--steps",
                       "1500", "--unjammed"});
    REQUIRE(model.run().exit_code == 0);
    return read_file(model.dump());
  };
  for (const Engine &engine : {liggghts, lammps, yade}) {
    if (!is_there(engine))
      continue;
    const std::string smooth = dump(engine, "0.05", "0.5");
    CHECK(smooth != dump(engine, "0.9", "0.5"));
    CHECK(smooth != dump(engine, "0.05", "0.9"));
    CHECK(smooth == dump(engine, "0.05", "0.5"));
  }
}

TEST_CASE("a plain bed comes to rest with its own friction where it was filled with another", "[engines]") {
  const auto dump = [](const Engine &engine, const std::string &friction) {
    const Model model(engine, c778(),
                      {"--start", "deposit", "--friction", friction, "--friction-while-filling", "0.5",
                       "--steps", "1500", "--unjammed"});
    const Outcome outcome = model.run();
    REQUIRE(outcome.exit_code == 0);
    CHECK(says(outcome, ", friction " + friction));
    return read_file(model.dump());
  };
  for (const Engine &engine : {liggghts, lammps, yade})
    if (is_there(engine))
      CHECK(dump(engine, "0.05") != dump(engine, "0.9"));
}

TEST_CASE("grains with cohesion hold by the law of their engine, and few are rattlers", "[engines]") {
  const auto check_law = [](const Engine &engine, const Arguments &options, const std::string &law,
                            const std::string &cohesion) {
    if (!is_there(engine))
      return;
    const Model model(engine, c778(), with({"--at-least", "300"}, options));
    check_result(model, "5e6", {"--wall", "box", "--law", law, cohesion});
    // 0.47 without.
    const std::string out = model.run().out;
    const std::size_t result = out.find("\nRESULT after ");
    REQUIRE(result != std::string::npos);
    CHECK(std::stod(out.substr(out.find(", rattlers ", result) + 11)) < 0.2);
  };
  check_law(liggghts, {"--cohesion-energy-density", "60000"}, "sjkr", "60000");
  check_law(lammps, {"--surface-energy", "0.003"}, "jkr", "0.003");
}

TEST_CASE("grains that resist rolling settle into a looser bed", "[engines]") {
  const auto void_ratio = [](const Engine &engine, const Arguments &more) {
    const Model model(engine, c778(), with({"--at-least", "300"}, more));
    const Outcome outcome = model.run();
    INFO(end_of(outcome));
    REQUIRE(outcome.exit_code == 0);
    const std::string words = "\nRESULT after ", ratio = ": void ratio ";
    const std::size_t result = outcome.out.find(words);
    REQUIRE(result != std::string::npos);
    return std::stod(outcome.out.substr(outcome.out.find(ratio, result) + ratio.size()));
  };
  for (const Engine &engine : {liggghts, lammps})
    if (is_there(engine))
      CHECK(void_ratio(engine, {"--rolling-friction", "0.5"}) > void_ratio(engine, {}));
}

} // namespace state_test
