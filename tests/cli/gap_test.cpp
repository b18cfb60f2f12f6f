// Searches that end near their bound.

#include "answer.hpp"

namespace gap_test {

using namespace cli_test;

TEST_CASE("a gap that is reached ends a search with bounds, their proof and exit code 0", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("ottawa-f65-sand");
  const Json answer =
      solve_json({sand, "--tolerance", "total:1%", "--gap", "0.5", "--proof", folder / "proof"});
  CHECK(answer.at("status") == "feasible");
  const Integer least(answer.at("lower_bound").get<std::string>());
  const Integer found(answer.at("particles").get<std::string>());
  CHECK(least < found);
  CHECK(2 * (found - least) <= found);
  CHECK(mdm_check(sand, folder / "proof").out.find(" is between ") != std::string::npos);
  // One that is not reached before the end changes nothing.
  CHECK(solve_json({sand, "--tolerance", "passing:2%", "--gap", "0"}).at("status") == "optimal");
}

TEST_CASE("a gap is of matches within a tolerance, and not negative", "[cli]") {
  const std::string sand = example("ottawa-f65-sand");
  check_refused(mdm({"solve", sand, "--gap", "0.1"}), "--gap");
  check_refused(mdm({"solve", sand, "--tolerance", "passing:2%", "--gap", "-1"}), "--gap");
}

TEST_CASE("a gap that is reached is enough in batch and export as well", "[cli]") {
  const TemporaryFolder folder;
  const std::string sand = example("ottawa-f65-sand");
  const Arguments gap = {"--tolerance", "total:1%", "--gap", "0.5"};
  const auto with_gap = [&gap](Arguments arguments) {
    arguments.insert(arguments.end(), gap.begin(), gap.end());
    return mdm(arguments);
  };
  const Outcome batch = with_gap({"batch", sand});
  CHECK(batch.exit_code == 0);
  CHECK(Json::parse(batch.out).at("status") == "feasible");
  CHECK(with_gap({"export", sand, "--to", "csv", "-o", folder / "sand.csv"}).exit_code == 0);
}

} // namespace gap_test
