#include "packing/deposit.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("A box that is too narrow is refused in the spelling of the front end") {
  DiscSizes sizes;
  sizes.sizes.assign(10, {1, 0});
  DepositOptions narrow;
  narrow.width = Rational(2);
  const auto refusal = [&] { return refusal_of([&] { deposit(sizes, narrow); }); };
  check_spellings(refusal, {"--width: the box", "width: the box", "width: the box"});
}

} // namespace option_spelling_test
