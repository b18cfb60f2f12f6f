#include "catch.hpp"
#include "match/problem.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

#include <fstream>
#include <map>
#include <sstream>

namespace suite_test {

using namespace mdm;

namespace {

std::ifstream opened(const std::string &path) {
  std::ifstream file(path);
  REQUIRE(file.good());
  return file;
}

std::vector<Integer> integers(const std::string &text) {
  std::istringstream words(text);
  std::vector<Integer> n;
  for (std::string word; words >> word;)
    n.emplace_back(word);
  return n;
}

} // namespace

TEST_CASE("every match that the published code found is at least ours in every class") {
  std::map<std::string, Match> matches;
  std::ifstream suite = opened(MDM_SUITE);
  for (std::string line; std::getline(suite, line);) {
    const Match m = solve(read_json_gradation(line, "suite", ""));
    matches.emplace(m.gradation.id(), m);
  }
  REQUIRE(matches.size() == 2750);

  std::ifstream answers = opened(MDM_DATA_DIR "/suite-2750-float-answers.csv");
  std::string line;
  std::getline(answers, line);
  int realisable = 0, below = 0, minimal = 0;
  while (std::getline(answers, line)) {
    const Match &m = matches.at(line.substr(0, line.find(',')));
    const std::vector<Integer> q = integers(line.substr(line.rfind(',') + 1));
    const std::vector<Integer> &least = m.sample->quantities;
    REQUIRE(q.size() == least.size());
    const Problem problem(m.gradation, {}, 1);
    if (problem.lowest_scale(q) >= problem.highest_scale(q)) {
      below += total(q) < total(least) ? 1 : 0;
      continue;
    }
    ++realisable;
    minimal += q == least ? 1 : 0;
    for (std::size_t j = 0; j < q.size(); ++j)
      CHECK(q[j] >= least[j]);
  }
  CHECK(realisable >= 5400);
  CHECK(minimal >= 23 + 782);
  INFO("answers that are no match and have fewer particles: " << below);
  CHECK(below >= 4);
}

TEST_CASE("real sands have the known numbers of particles") {
  const std::map<std::string, int> expected = {{"athabasca-sand", 1485},    {"c778-graded-sand", 141},
                                               {"cen-standard-sand", 2977}, {"limestone-pfc", 12078},
                                               {"hostun-rf-sand", 31},      {"ottawa-f65-sand", 2498}};
  for (const auto &[name, n] : expected) {
    const Match m = solve(read_gradation_file(MDM_SOURCE_DIR "/examples/gradations/" + name + ".csv"));
    CHECK(m.particles() == n);
    if (name == "athabasca-sand")
      CHECK(m.sample->quantities == integers("819 90 280 268 25 2 1"));
  }
}

} // namespace suite_test
