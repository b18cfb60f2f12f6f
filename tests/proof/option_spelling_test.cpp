#include "plain_gradation.hpp"
#include "proof/vipr.hpp"
#include "spellings.hpp"

#include <mdm/match/solve.hpp>

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("A proof that cannot be exported is refused in the spelling of the front end") {
  Question question;
  question.law = {5, 2};
  SolveOptions options;
  options.limits.keep_proof = true;
  const Match match = solve(gradation({1, 2, 3}, {1, 1, 0}), question, options);
  const auto refusal = [&match] { return refusal_of([&match] { vipr(match); }); };
  check_spellings(refusal, {"--vipr: the mass law", "vipr: the mass law", "vipr: the mass law"});
}

} // namespace option_spelling_test
