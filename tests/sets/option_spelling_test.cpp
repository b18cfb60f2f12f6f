#include "sets/matched_set.hpp"
#include "sets/sieve_curve.hpp"
#include "soil/soil.hpp"
#include "spellings.hpp"

namespace option_spelling_test {

using namespace mdm;
using namespace mdm_test;

TEST_CASE("A set that cannot be made is refused in the spelling of the front end") {
  const auto pan = [] {
    return refusal_of([] {
      SieveCurve(grading_test::curve({{"0", "0"}, {"1", "100"}}), Interpolation::log);
    });
  };
  check_spellings(pan, {"give the pan one with --pan-size", "give the pan one with pan_size",
                        "give the pan one with panSize"});
  const SieveCurve curve(grading_test::curve({{"1", "0"}, {"1.001", "100"}}), Interpolation::log);
  const auto digits = [&curve] {
    return refusal_of([&curve] { rounded_gradation(size_classes(curve, Classing::regular, 3), 2, "set"); });
  };
  check_spellings(
      digits, {"give more with --match-digits", "give more with match_digits", "give more with matchDigits"});
}

} // namespace option_spelling_test
