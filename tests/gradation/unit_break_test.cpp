#include "../catch.hpp"
#include "gradation/unit_break.hpp"

namespace unit_break_test {

using namespace mdm;

TEST_CASE("The order of sieves tells where micrometres begin") {
  CHECK(unit_break({4, 2, ratio(118, 100), 600, 300, 63}) == 3);
  CHECK(unit_break({2, 1, ratio(1, 2), 250, 125, 63}) == 3);
  CHECK(unit_break({2, 1, 500, 250, 0}) == 2);
  CHECK(unit_break({63, 300, 600, ratio(118, 100), 2}) == 3);
}

TEST_CASE("An order that one unit may have tells nothing") {
  CHECK_FALSE(unit_break({}));
  CHECK_FALSE(unit_break({600, 300, 63}));
  CHECK_FALSE(unit_break({1, 2, 4}));
  CHECK_FALSE(unit_break({2, ratio(1, 2), 1, 4}));
  CHECK_FALSE(unit_break({8, 63, 31}));
  CHECK_FALSE(unit_break({2, 1, 500, 250, 600}));
  CHECK_FALSE(unit_break({2, 1, ratio(63, 2), 25}));
}

TEST_CASE("Sieves in um below a header of mm are known by their sizes") {
  CHECK(may_be_micrometres({600, 425, 300, 63}));
  CHECK(may_be_micrometres({28000, 600, 212, 0}));
  CHECK(may_be_micrometres({250, 125, ratio(125, 2)}));
}

TEST_CASE("Sieves that may be in mm are no micrometres") {
  CHECK_FALSE(may_be_micrometres({}));
  CHECK_FALSE(may_be_micrometres({125, 63, 20}));
  CHECK_FALSE(may_be_micrometres({300, 75, ratio(475, 100)}));
  CHECK_FALSE(may_be_micrometres({300, 150, 75, 19}));
}

} // namespace unit_break_test
