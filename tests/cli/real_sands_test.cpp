// Real sands, solved, reported in each form, proved and checked.

#include "answer.hpp"

namespace real_sands_test {

using namespace cli_test;

namespace {

/// Solves an example with a proof, checks the proof and everything that the answer says of itself.
Json proved(const std::string &name) {
  const TemporaryFolder folder;
  const std::string proof = folder / "sand.proof";
  const Json answer = solve_json({example(name), "--proof", proof});
  check_match(answer);
  CHECK(answer.at("id") == name);
  CHECK(answer.at("status") == "optimal");
  CHECK(answer.at("lower_bound") == answer.at("particles"));
  const Outcome verdict = mdm_check(example(name), proof);
  INFO(verdict.out << verdict.err);
  CHECK(verdict.exit_code == 0);
  CHECK(verdict.out.find("accepted: N = " + answer.at("particles").get<std::string>() + " ") == 0);
  return answer;
}

} // namespace

TEST_CASE("Athabasca sand has a smallest match of 1485 particles", "[cli]") {
  const Json answer = proved("athabasca-sand");
  CHECK(answer.at("particles") == "1485");
  CHECK(quantities(answer) == "819 90 280 268 25 2 1");
  CHECK(answer.at("unit") == "mm");
  CHECK(answer.at("classes").at(0).at("lower") == "0.038");
  CHECK(answer.at("classes").at(0).at("mass") == "3.86");
}

TEST_CASE("C778 graded sand, by sieve names, has a smallest match of 141 particles", "[cli]") {
  const Json answer = proved("c778-graded-sand");
  CHECK(quantities(answer) == "22 67 41 10 1");
  CHECK(answer.at("unit") == "mm");
  CHECK(answer.at("classes").at(0).at("lower") == "0.075");
}

TEST_CASE("CEN standard sand, with a pan at 0, has a smallest match of 2977 particles", "[cli]") {
  const Json answer = proved("cen-standard-sand");
  CHECK(quantities(answer) == "1143 1715 94 20 4 1");
  CHECK(answer.at("classes").at(0).at("lower") == "0");
}

TEST_CASE("limestone, by mass retained, has a smallest match of 12078 particles", "[cli]") {
  const Json answer = proved("limestone-pfc");
  CHECK(quantities(answer) == "5977 2522 1462 766 682 389 220 51 8 1");
}

TEST_CASE("Hostun RF sand has a smallest match of 31 particles", "[cli]") {
  CHECK(quantities(proved("hostun-rf-sand")) == "7 5 7 5 4 2 1");
}

TEST_CASE("Ottawa F-65 sand, by fractions, has a smallest match of 2498 particles", "[cli]") {
  const Json answer = proved("ottawa-f65-sand");
  CHECK(answer.at("particles") == "2498");
  CHECK(answer.at("classes").size() == 19);
}

TEST_CASE("a specification band is no curve to solve", "[cli]") {
  check_refused(mdm({"solve", example("c33-fine-aggregate-limits")}), "band");
}

TEST_CASE("the text form shows the number of particles and every quantity", "[cli]") {
  const Outcome outcome = mdm({"solve", example("athabasca-sand")});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.err.empty());
  CHECK(outcome.out.find("athabasca-sand: 1485 particles") == 0);
  for (const char *part : {" 819 ", " 90 ", " 280 ", " 268 ", " 25 ", " 2 ", " 1 ", "(0.038, 0.076]", "mm"})
    CHECK(outcome.out.find(part) != std::string::npos);
}

TEST_CASE("the CSV form has a row a class and the unit in its header", "[cli]") {
  const Outcome outcome = mdm({"solve", example("athabasca-sand"), "--format", "csv"});
  CHECK(outcome.exit_code == 0);
  CHECK(outcome.out.find(
            "lower_mm,upper_mm,mass,quantity,size_lo_mm,size_hi_mm\n0.038,0.076,3.86,819,0.075") == 0);
  CHECK(std::count(outcome.out.begin(), outcome.out.end(), '\n') == 8);
}

TEST_CASE("an empty class has quantity 0 and no size", "[cli]") {
  const std::string gradation = "size_mm,mass\n1,2\n2,0\n3,1\n4,0\n";
  const Json answer = solve_json({"-"}, 0, gradation);
  check_match(answer);
  CHECK(answer.at("classes").at(1).at("quantity") == "0");
  CHECK(answer.at("classes").at(1).at("size").is_null());
  CHECK(mdm({"solve", "-", "--format", "csv"}, gradation).out.find("\n2,3,0,0,,\n") != std::string::npos);
}

TEST_CASE("other units are named in the answer", "[cli]") {
  const std::string gradation = "size_um,mass\n75,2\n150,1\n300,0\n";
  CHECK(solve_json({"-"}, 0, gradation).at("unit") == "um");
  CHECK(mdm({"solve", "-", "--format", "csv"}, gradation).out.find("lower_um,upper_um,") == 0);
  CHECK(solve_json({"-"}, 0, "size_in,mass\n0.375,1\n1,0\n").at("classes").at(0).at("lower") == "9.525");
  CHECK(solve_json({"-"}, 0, "sieve,mass\n3/8 in,1\n1 in,0\n").at("classes").at(0).at("lower") == "9.5");
}

} // namespace real_sands_test
