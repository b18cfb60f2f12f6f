#include "plain_gradation.hpp"
#include "plot/tradeoff_figure.hpp"
#include "report/verification.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("A verdict that ranges leave open names the tolerance in the spelling of the front end") {
  Description ranges(gradation({1, 2, 3}, {1, 1, 0}));
  ranges.add(SizeRange{ratio(3, 2), ratio(8, 5)}, 4);  // 13.5 to 16.4 of the mass
  ranges.add(SizeRange{ratio(5, 2), ratio(13, 5)}, 1); // 15.6 to 17.6
  const Verification v(std::move(ranges), {}, 0);
  REQUIRE(v.verdict() == Verdict::undecided);
  check_spellings([&v] { return headline(v); }, {"(a --tolerance of", "(a tolerance of", "(a tolerance of"});
}

TEST_CASE("A picture of nothing is refused in the spelling of the front end") {
  const Tradeoff nothing{{}, gradation({1, 2}, {1, 0}), AskedTolerance::Kind::retained, {}, {}, {}};
  const auto refusal = [&nothing] { return refusal_of([&nothing] { tradeoff_figure(nothing); }); };
  check_spellings(refusal, {"leave out --plot", "leave out plot", "leave out plot"});
}

} // namespace option_spelling_test
