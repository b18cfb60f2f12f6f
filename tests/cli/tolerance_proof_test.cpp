// The proofs of mdm solve and mdm batch within tolerances, as a user gives them to mdm-check.

#include "answer.hpp"

namespace tolerance_proof_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");

/// Its smallest match within a total of 1 % has more particles than are certain without a search.
const std::string ottawa = example("ottawa-f65-sand");

const std::string file_with_tolerances = "size_mm,mass,tolerance_percent\n0,2,30\n2,1,4\n5,1,10\n9,0,0\n";

/// The verdict on the proof of a question, which has to be accepted.
std::string verdict(const std::string &gradation, const Arguments &options, int exit_code = 0) {
  const TemporaryFolder folder;
  Arguments arguments{"solve", gradation, "--proof", folder / "proof"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const Outcome outcome = mdm(arguments);
  INFO(outcome.out << outcome.err);
  CHECK(outcome.exit_code == exit_code);
  const Outcome checked = mdm_check(gradation, folder / "proof");
  INFO(checked.out << checked.err);
  CHECK(checked.exit_code == 0);
  return checked.out;
}

} // namespace

TEST_CASE("every kind of tolerance has a proof whose verdict repeats it", "[cli]") {
  CHECK(contains(verdict(athabasca, {"--tolerance", "retained:1%"}),
                 "within a tolerance (retained within 1% of the total mass; mass law x^3; sizes in mm)"));
  CHECK(contains(
      verdict(athabasca, {"--tolerance", "passing:0.5%", "--tolerance", "total:3%"}),
      "(passing within 0.5% of the total mass; total deviation within 3% of the total mass; mass law"));
  CHECK(contains(verdict(athabasca, {"--tolerance", "laboratory"}), "(passing within "));
  CHECK(contains(verdict(athabasca, {"--tolerance", "rounding", "--at-least", "5000"}),
                 "particles, 5000 or more, that"));
  const TemporaryFolder folder;
  const std::string file = folder.write("file.csv", file_with_tolerances);
  CHECK(contains(verdict(file, {"--tolerance", "retained:file"}),
                 "(retained within the file's tolerances; mass law x^3;"));
  CHECK(contains(
      verdict(file, {"--tolerance", "passing:file", "--min-per-class", "2"}),
      "(passing within the file's tolerances; mass law x^3; sizes in mm; at least 2 particles in each "
      "class with mass)"));
}

TEST_CASE("the proof of a band alone is checked with the band's own file", "[cli]") {
  const TemporaryFolder folder;
  const std::string band = folder.write("band.csv", "size_um,passing_min_percent,passing_max_percent\n"
                                                    "2000,40,60\n5000,60,80.5\n9000,100,100\n");
  const std::string file = folder.write("file.csv", file_with_tolerances);
  CHECK(contains(verdict(file, {"--band", band}),
                 "(40 to 60% of the total mass passing 2 mm of the file; 60 to 80.5% of the total "
                 "mass passing 5 mm of the file; 100 to 100% of the total mass passing 9 mm of the file; "
                 "mass law x^3; sizes in mm)"));
  const std::string proof = folder / "proof";
  CHECK(mdm({"solve", "--band", band, "--proof", proof}).exit_code == 0);
  CHECK(folder.entries() == 3);
  CHECK(contains(mdm_check(band, proof).out,
                 "(passing within the file's limits; mass law x^3; sizes in um; a pan "
                 "implied below the finest sieve; masses from the middle of the file's "
                 "limits)"));
}

TEST_CASE("that no sample is within a tolerance has a proof", "[cli]") {
  const TemporaryFolder folder;
  const std::string band =
      folder.write("band.csv", "size_mm,passing_min_percent,passing_max_percent\n2,50,60\n5,20,40\n");
  const std::string file = folder.write("file.csv", file_with_tolerances);
  CHECK(contains(verdict(file, {"--band", band}, 1), "accepted: no number of particles matches "));
}

TEST_CASE("a search that a limit has ended leaves a proof of its bounds", "[cli]") {
  for (const char *nodes : {"0", "1", "3", "4"}) {
    const Arguments limited = {"--tolerance", "total:1%", "--node-limit", nodes};
    const std::string line = verdict(ottawa, limited, 3);
    Arguments arguments = {ottawa};
    arguments.insert(arguments.end(), limited.begin(), limited.end());
    const Json answer = solve_json(arguments, 3);
    CHECK(contains(line, " is between " + answer.at("lower_bound").get<std::string>() + " and " +
                             answer.at("upper_bound").get<std::string>() + " (total deviation within 1%"));
  }
}

TEST_CASE("a proof of bounds is a theorem and no VIPR file, and an old file is called old", "[cli]") {
  const TemporaryFolder folder;
  const std::string old = folder.write("vipr", "old");
  const Arguments ask = {"solve", ottawa, "--tolerance", "total:1%", "--node-limit", "1"};
  const auto with = [&ask](Arguments more) {
    more.insert(more.begin(), ask.begin(), ask.end());
    return mdm(more);
  };
  const Outcome outcome = with({"--proof", folder / "proof", "--vipr", old, "--coq", folder / "sand.v"});
  CHECK(outcome.exit_code == 3);
  CHECK(contains(outcome.out, "no proof was written to " + old +
                                  ": the limit came before the end; the file that is there is older\n"));
  CHECK(contains(outcome.out, "the proof is of the bounds: N is at least "));
  CHECK(folder.entries() == 3);
  CHECK(contains(with({"--vipr", folder / "new"}).out,
                 "no proof was written to " + folder / "new" + ": the limit came before the end\n"));
  CHECK(folder.entries() == 3);
}

TEST_CASE("a batch within a tolerance writes the proof of each line", "[cli]") {
  const TemporaryFolder folder;
  const std::string line = R"({"id": "a", "sizes": [0, 2, 5, 9], "masses": [2, 1, 1, 0]})";
  CHECK(mdm({"batch", "--tolerance", "retained:5%", "--proofs", folder / "proofs"}, line + "\n" + line + "\n")
            .exit_code == 0);
  const std::string gradation = folder.write("line.json", line);
  CHECK(mdm_check(gradation, folder / "proofs/000001-a.proof").exit_code == 0);
  CHECK(mdm_check(gradation, folder / "proofs/000002-a.proof").exit_code == 0);
}

TEST_CASE("where the chain's proof would be too long, what was asked for is proved in time", "[cli]") {
  std::string many = "size_um,mass\n";
  for (unsigned i = 0; i < 1500; ++i)
    many += std::to_string(1000 + i) + "," + std::to_string(100 + i * 7919 % 1901) + "\n";
  const TemporaryFolder folder;
  const std::string file = folder.write("many.csv", many + "3000,0\n");
  CHECK(contains(verdict(file, {"--tolerance", "0.05%", "--node-limit", "1"}, 3), " is between "));
}

TEST_CASE("a tree that is too long for a proof proves its bound with fewer windows", "[cli]") {
  const TemporaryFolder folder;
  const std::string curve = folder.write("curve.csv", "size_mm,mass\n120,2\n155,1\n95,3\n86,2\n143,0\n196,"
                                                      "1\n169,2\n246,1\n263,5\n277,0\n217,1\n179,2\n171,5\n");
  const std::string band = folder.write(
      "band.csv", "size_mm,passing_min_percent,passing_max_percent\n169,25,32\n263,70,81\n554,100,100\n");
  const Outcome outcome = mdm({"solve", curve, "--tolerance", "total:16", "--law", "power:2", "--band", band,
                               "--node-limit", "3000", "--proof", folder / "p"});
  CHECK(outcome.exit_code == 3);
  CHECK(contains(outcome.out, "has N in [18, 26]"));
  CHECK(contains(outcome.out, "the proof is of the bounds: N is at least 18"));
  CHECK(mdm_check(curve, folder / "p").exit_code == 0);
}

} // namespace tolerance_proof_test
