// mdm solve --spread: many sizes in a class, and still the exact mass.

#include "answer.hpp"

#include <set>
#include <sstream>

namespace spread_test {

using namespace cli_test;

namespace {

const std::string athabasca = example("athabasca-sand");

/// The particles' cubes, by the ends of their enclosures, are around the mass s m_j that the class must have,
/// so that sizes in the enclosures have it exactly; all are inside the class.
void check_sizes(const Json &c, const Rational &mass) {
  REQUIRE(std::to_string(c.at("sizes").size()) == c.at("quantity"));
  Rational low = 0, high = 0;
  for (const Json &size : c.at("sizes")) {
    const Rational lo = rational(size.at(0)), hi = rational(size.at(1));
    CHECK(rational(c.at("lower")) < lo);
    CHECK(lo <= hi);
    CHECK(hi <= rational(c.at("upper")));
    low += cube(lo);
    high += cube(hi);
  }
  CHECK(low <= mass);
  CHECK(mass <= high);
}

/// A spread's CSV as a sample file: every size at its upper end.
std::string sample_of(const std::string &csv) {
  std::istringstream lines(csv);
  std::string sample = "size_mm,quantity\n", line;
  std::getline(lines, line);
  CHECK(line == "lower_mm,upper_mm,size_lo_mm,size_hi_mm");
  while (std::getline(lines, line))
    sample += line.substr(line.rfind(',') + 1) + ",1\n";
  return sample;
}

} // namespace

TEST_CASE("a spread has every class's mass exactly, whatever the seed", "[cli]") {
  for (const char *seed : {"0", "1", "18446744073709551615"}) {
    const Json answer = solve_json({athabasca, "--min-per-class", "20", "--spread", "--seed", seed});
    check_match(answer);
    CHECK(answer.at("seed") == seed);
    const Rational s = rational(answer.at("scale").at("chosen"));
    for (const Json &c : answer.at("classes"))
      check_sizes(c, s * rational(c.at("mass")));
  }
}

TEST_CASE("a spread within a tolerance has the masses that were achieved", "[cli]") {
  const Json answer = solve_json({athabasca, "--tolerance", "retained:1%", "--spread"});
  const Rational s = rational(answer.at("scale").at("chosen"));
  for (std::size_t j = 0; j < answer.at("classes").size(); ++j) {
    const Json &c = answer.at("classes")[j];
    if (c.at("quantity") == "0")
      CHECK_FALSE(c.contains("sizes"));
    else
      check_sizes(c, s * rational(answer.at("achieved")[j]));
  }
}

TEST_CASE("the same seed gives the same bytes, another one other sizes", "[cli]") {
  const auto spread = [](const char *seed) {
    return mdm({"solve", athabasca, "--spread", "--seed", seed, "--format", "csv"}).out;
  };
  const std::string one = spread("1");
  CHECK(one == mdm({"solve", athabasca, "--spread", "--format", "csv"}).out);
  CHECK(one != spread("2"));
  std::istringstream lines(one);
  std::set<std::string> different;
  for (std::string line; std::getline(lines, line);)
    different.insert(line);
  CHECK(different.size() == 1486);
}

TEST_CASE("verify takes a spread for what it is", "[cli]") {
  const TemporaryFolder folder;
  const Outcome csv = mdm({"solve", athabasca, "--spread", "--format", "csv"});
  const std::string sample = folder.write("sample.csv", sample_of(csv.out));
  // Decimals match within their digits, not exactly.
  CHECK(mdm({"verify", athabasca, sample, "--tolerance", "0.0000000001"}).exit_code == 0);
  CHECK(mdm({"verify", athabasca, sample}).exit_code == 1);
  const std::string spoilt =
      folder.write("spoilt.csv", read_file(sample).replace(read_file(sample).rfind("0."), 2, "1."));
  CHECK(mdm({"verify", athabasca, spoilt, "--tolerance", "1"}).exit_code == 1);
  const Outcome answer = mdm({"solve", athabasca, "--spread", "--format", "json"});
  CHECK(mdm({"verify", athabasca, folder.write("answer.json", answer.out)}).exit_code == 0);
}

TEST_CASE("verify judges the sizes of a spread in an answer", "[cli]") {
  const TemporaryFolder folder;
  for (const char *law : {"sphere", "power:5/2"}) {
    const Json answer = solve_json({athabasca, "--spread", "--law", law});
    const auto verified = [&](const Json &changed) {
      return mdm({"verify", athabasca, folder.write("answer.json", changed.dump()), "--law", law});
    };
    const Outcome good = verified(answer);
    CHECK(good.exit_code == 0);
    CHECK(good.out.find("The answer is a spread") != std::string::npos);
    const auto objected = [&](std::size_t j, const std::string &objection, auto change) {
      Json changed = answer;
      change(changed.at("classes").at(j).at("sizes"));
      const Outcome outcome = verified(changed);
      INFO(outcome.out << outcome.err);
      CHECK(outcome.exit_code == 1);
      CHECK(outcome.out.find(objection) != std::string::npos);
    };
    objected(4, "sizes are listed for its", [](Json &sizes) { sizes.erase(3); });
    objected(4, "not in it", [](Json &sizes) { sizes[7] = {"0.24", "0.241"}; });
    objected(4, "not in it", [](Json &sizes) { sizes[7] = {"0.42", "0.4300001"}; });
    objected(4, "not in it", [](Json &sizes) { sizes[7] = {"0.25", "0.25"}; });
    objected(4, "do not have its mass", [](Json &sizes) { sizes[7] = {"0.4", "0.41"}; });
    objected(5, "do not have its mass", [](Json &sizes) { sizes[0] = sizes[1] = {"0.83", "0.84"}; });
  }
  const Json answer = solve_json({athabasca, "--spread"});
  const std::string other = folder.write("other.csv", "size_mm,mass\n0.038,1\n0.1,1\n0.2,1\n5,0\n");
  const std::string file = folder.write("answer.json", answer.dump());
  check_refused(mdm({"verify", other, file}), "a sieve of 0.1 there");
  Json broken = answer;
  broken.at("classes").at(4).at("sizes") = "0.4";
  check_refused(mdm({"verify", athabasca, folder.write("broken.json", broken.dump())}), "no list of sizes");
}

TEST_CASE("the text shows how far a spread reaches", "[cli]") {
  const Outcome text = mdm({"solve", athabasca, "--spread", "--seed", "9"});
  CHECK(text.exit_code == 0);
  CHECK(text.out.find("seed 9") != std::string::npos);
  CHECK(text.out.find("smallest size (mm)") != std::string::npos);
}

TEST_CASE("without an answer there is no spread", "[cli]") {
  const Json answer = solve_json({athabasca, "--at-most", "10", "--spread"}, 1);
  CHECK_FALSE(answer.contains("seed"));
}

TEST_CASE("the sizes of a spread are streamed", "[cli]") {
  const TemporaryFolder folder;
  const Outcome outcome =
      mdm({"solve", athabasca, "--at-least", "200000", "--spread", "--format", "csv", "-o", folder / "out"});
  CHECK(outcome.exit_code == 0);
  const std::string text = read_file(folder / "out");
  CHECK(std::count(text.begin(), text.end(), '\n') == 200001);
  if (!MDM_IS_SANITIZED)
    CHECK(outcome.max_rss_kib < 40000);
}

TEST_CASE("options of a spread that make no sense are refused", "[cli]") {
  check_refused(mdm({"solve", athabasca, "--seed", "1"}), "--spread");
  check_refused(mdm({"solve", athabasca, "--spread", "--seed", "-1"}), "--seed");
  check_refused(mdm({"solve", athabasca, "--spread", "--seed", "18446744073709551616"}), "--seed");
  check_refused(mdm({"solve", athabasca, "--spread", "--at-least", "2000000000"}), "1000000000");
}

TEST_CASE("no particle of a spread is on the open lower sieve", "[cli]") {
  // The mass 152 = 27 + 125 leaves the first size no place but 3.
  const TemporaryFolder folder;
  const std::string gradation = folder.write("g.csv", "size_mm,mass\n3,152\n9,0\n");
  const auto verify = [&](const std::string &first) {
    const std::string answer =
        R"({"schema":"mdm-answer-1","id":"g","status":"optimal","unit":"mm","particles":"2",)"
        R"("scale":{"chosen":"1"},"classes":[{"lower":"3","upper":"9","mass":"152","quantity":"2",)"
        R"("size":["4.2","4.3"],"sizes":[)" +
        first + R"(,["5","5"]]}]})";
    return mdm({"verify", gradation, "-"}, answer);
  };
  CHECK(verify(R"(["3","3.5"])").exit_code == 1);
  CHECK(contains(verify(R"(["3","3.5"])").out, "its sizes do not have its mass together"));
}

} // namespace spread_test
