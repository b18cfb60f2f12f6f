// Every pair of files in tests/certificates is a test: the folder says the verdict.

#include "catch.hpp"
#include "program.hpp"

#include <algorithm>

using namespace mdm_check_test;

namespace {

bool is_one_line(const std::string &text) {
  return text.size() > 1 && std::count(text.begin(), text.end(), '\n') == 1 && text.back() == '\n';
}

void judge_folder(const std::string &name, int exit_code, const std::string &beginning,
                  std::size_t least_tests) {
  std::size_t tests = 0;
  for (const auto &entry :
       std::filesystem::directory_iterator(std::filesystem::path(MDM_CERTIFICATES_DIR) / name)) {
    std::filesystem::path proof = entry.path();
    if (proof.extension() != ".proof")
      continue;
    std::filesystem::path gradation = proof;
    gradation.replace_extension(".csv");
    if (!std::filesystem::exists(gradation))
      gradation.replace_extension(".json");
    const Outcome outcome = run({gradation.string(), proof.string()});
    INFO(proof << "\n" << outcome.out << outcome.err);
    CHECK(outcome.exit_code == exit_code);
    CHECK(is_one_line(exit_code == 2 ? outcome.err : outcome.out));
    CHECK((exit_code == 2 ? outcome.out : outcome.err).empty());
    CHECK((exit_code == 2 ? outcome.err : outcome.out).rfind(beginning, 0) == 0);
    ++tests;
  }
  CHECK(tests >= least_tests);
}

} // namespace

TEST_CASE("the checker accepts the certificates of accepted", "[checker]") {
  judge_folder("accepted", 0, "accepted: ", 20);
}

TEST_CASE("the checker refuses the certificates of rejected", "[checker]") {
  judge_folder("rejected", 1, "refused: ", 25);
}

TEST_CASE("the checker cannot read the certificates of unparsable", "[checker]") {
  judge_folder("unparsable", 2, MDM_CERTIFICATES_DIR, 25);
}

TEST_CASE("the verdict repeats the question", "[checker]") {
  const std::filesystem::path folder = std::filesystem::path(MDM_CERTIFICATES_DIR) / "accepted";
  const auto verdict = [&](const std::string &name) {
    return run({"-", (folder / (name + ".proof")).string()}, (folder / (name + ".csv")).string()).out;
  };
  CHECK(verdict("at_least_everything") == "accepted: N = 60 is the least number of particles from 60 up that "
                                          "matches standard input exactly (law x^3; at "
                                          "least 2 particles in each class; solids of the cylinder 6 x 5 at "
                                          "void ratio 0.5; openings multiplied by 1.5; "
                                          "classes below 1 left out; pan counted as size 0.9)\n");
  CHECK(verdict("box") ==
        "accepted: N = 5122 is the least number of particles that matches standard input exactly "
        "(law x^3; solids of the box 3 x 2.5 x 2 at void ratio 0.7)\n");
  CHECK(verdict("power_5_2") == "accepted: N = 167 is the least number of particles that matches standard "
                                "input exactly (law x^(5/2))\n");
}
