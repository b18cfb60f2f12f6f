#include "papers/packing_study.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("Too few discs are refused in the spelling of the front end") {
  const auto refusal = [] { return refusal_of([] { equal_disc_facts({9, 1000}); }); };
  check_spellings(refusal, {"raise --at-least", "raise at_least", "raise atLeast"});
}

} // namespace option_spelling_test
