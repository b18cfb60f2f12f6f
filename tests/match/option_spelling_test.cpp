#include "plain_gradation.hpp"
#include "spellings.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/match/solve.hpp>

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("A question that cannot be asked is refused in the spelling of the front end") {
  Question volume;
  volume.law = {2, 1};
  volume.solids = Cylinder{10, 10, ratio(1, 2)};
  const auto refusal = [&volume] {
    return refusal_of([&volume] { solve(gradation({1, 2, 3}, {1, 1, 0}), volume); });
  };
  check_spellings(refusal, {"leave out --law", "leave out law", "leave out law"});
}

TEST_CASE("An answer at its most steps says which option allows more, in the spelling of the front end") {
  // Some 10^11 steps: its sieves are that narrow.
  const Gradation narrow = read_gradation(
      "size_mm,mass\n1,1\n1.00000000001,1.3\n1.00000000002,1.7\n1.00000000003,0\n", "sand.csv");
  const auto notes = [&narrow] {
    std::string all;
    for (const std::string &note : solve(narrow).notes)
      all += note + "\n";
    return all;
  };
  check_spellings(notes, {": --max-steps allows more", ": max_steps allows more", ": maxSteps allows more"});
}

} // namespace option_spelling_test
