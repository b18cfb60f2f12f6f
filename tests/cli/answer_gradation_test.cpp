// Answers in JSON as gradations: what describe, convert and others read of them is what their particles have.

#include "answer.hpp"

namespace answer_gradation_test {

using namespace cli_test;

namespace {

/// Solves the gradation, makes a gradation of the answer, and holds the answer against that, which it matches
/// exactly.
std::string round_trip(const std::string &gradation, const Arguments &options = {}) {
  const TemporaryFolder folder;
  const std::string answer = folder / "a.json", converted = folder / "g.csv";
  Arguments solve{"solve", gradation, "-o", answer};
  solve.insert(solve.end(), options.begin(), options.end());
  REQUIRE(mdm(solve).exit_code == 0);
  const Outcome made = mdm({"convert", answer, "-o", converted});
  INFO(made.err);
  CHECK(made.exit_code == 0);
  CHECK(contains(made.err, "the gradation is that of the "));
  const Outcome verified = mdm({"verify", converted, answer});
  INFO(verified.out << verified.err);
  CHECK(verified.exit_code == 0);
  CHECK(contains(verified.out, "matches exactly"));
  return read_file(converted);
}

} // namespace

TEST_CASE("the gradation of an exact match is the one that was asked for", "[cli]") {
  const std::string sand = example("athabasca-sand");
  CHECK(round_trip(sand) == mdm({"convert", sand}).out);
}

TEST_CASE("the gradation of a match within a tolerance is that of its particles", "[cli]") {
  const std::string sand = example("athabasca-sand");
  for (const char *tolerance : {"1%", "passing:1%", "total:0.5%", "laboratory"})
    CHECK(round_trip(sand, {"--tolerance", tolerance}) != mdm({"convert", sand}).out);
}

TEST_CASE("the gradation of an answer in um, or whose classes were changed", "[cli]") {
  const TemporaryFolder folder;
  const std::string um = folder.write("um.csv", "size_um,mass\n0,1\n63,1\n125,3\n250,0\n500,0\n");
  CHECK(round_trip(um) == "size_um,mass\n0,1\n63,1\n125,3\n250,0\n500,0\n");
  CHECK(round_trip(um, {"--cut-below", "63um", "--size-factor", "2"}) ==
        "size_um,mass\n126,1\n250,3\n500,0\n1000,0\n");
}

TEST_CASE("the gradation of an answer has the factors that its classes had", "[cli]") {
  const TemporaryFolder folder;
  const std::string shells = folder.write("f.csv", "size_mm,mass,factor\n1,1,2\n2,1,3.5\n4,0,1\n");
  CHECK(round_trip(shells) == "size_mm,mass,factor\n1,1,2\n2,1,3.5\n4,0,1\n");
}

TEST_CASE("an answer of irrational openings is a gradation, too", "[cli]") {
  const TemporaryFolder folder;
  const std::string phi = folder.write("phi.csv", "size_phi,mass\n2.5,3\n1.5,2\n0.5,0\n"),
                    answer = folder / "a.json";
  REQUIRE(mdm({"solve", phi, "-o", answer}).exit_code == 0);
  CHECK(mdm({"describe", answer, "--format", "json"}).exit_code == 0);
  CHECK(mdm({"convert", answer}).out == mdm({"convert", phi}).out);
}

TEST_CASE("an answer is a gradation from standard input and for a picture, too", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("athabasca-sand"), answer = folder / "a.json";
  REQUIRE(mdm({"solve", sand, "-o", answer}).exit_code == 0);
  CHECK(mdm({"convert", "-"}, read_file(answer)).out == mdm({"convert", sand}).out);
  CHECK(mdm({"plot", answer, "-o", folder / "a.svg"}).exit_code == 0);
  check_refused(mdm({"describe", "-"}, read_file(answer) + read_file(answer)),
                "stdin:2: another answer begins here");
}

TEST_CASE("sizes in ranges are steps of the curve, as single sizes are", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("athabasca-sand"), answer = folder / "a.csv", grains = folder / "g.csv";
  REQUIRE(mdm({"solve", sand, "-o", answer}).exit_code == 0);
  REQUIRE(mdm({"export", sand, "--to", "csv", "-o", grains, "--quiet"}).exit_code == 0);
  const auto passing = [](const std::string &file) {
    std::string all;
    for (const std::string &row :
         lines_of(mdm({"judge", file, "--spec", "astm-c33-fine", "--format", "csv"}).out))
      all += row.substr(row.find(',')) + "\n"; // without the sample's name
    return all;
  };
  CHECK(contains(passing(grains), ",81.35"));
  CHECK(contains(passing(answer), ",81.35"));
  const std::string json = folder / "a.json";
  REQUIRE(mdm({"solve", sand, "-o", json}).exit_code == 0);
  CHECK(contains(passing(json), ",81.35"));
}

TEST_CASE("an answer without particles, or of several materials, is no gradation", "[cli]") {
  const TemporaryFolder folder;
  const std::string none = folder / "none.json", materials = folder / "materials.json";
  CHECK(mdm({"solve", example("athabasca-sand"), "--tolerance", "0.1%", "--at-most", "2", "-o", none})
            .exit_code == 1);
  check_refused(mdm({"describe", none}), "there is no sample");
  const std::string two =
      folder.write("two.csv", "size_mm,mass,material\n1,8,quartz\n2,0,quartz\n1,8,shell\n4,0,shell\n");
  CHECK(mdm({"solve", two, "-o", materials}).exit_code == 0);
  check_refused(mdm({"convert", materials}), "of several materials");
}

} // namespace answer_gradation_test
