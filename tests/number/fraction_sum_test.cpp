#include "catch.hpp"
#include "number/fraction_sum.hpp"

#include <random>

namespace fraction_sum_test {

using namespace mdm;

TEST_CASE("FractionSum: equals the sum one by one") {
  std::mt19937 random(1);
  std::uniform_int_distribution<int> numerators(-50, 50), denominators(1, 60);
  FractionSum sum;
  Rational expected = 0;
  CHECK(sum.value() == 0);
  for (int i = 0; i < 2000; ++i) {
    const int n = numerators(random), d = denominators(random);
    sum.add(n, d);
    expected += ratio(n, d);
    CHECK(sum.value() == expected);
  }
}

} // namespace fraction_sum_test
