#include "catch.hpp"
#include "number/decimal_exponent.hpp"

#include <mdm/number/decimal.hpp>

namespace decimal_exponent_test {

using namespace mdm;

TEST_CASE("powers of ten are fractions where the exponent is negative") {
  CHECK(ten_to(0) == 1);
  CHECK(ten_to(3) == 1000);
  CHECK(ten_to(-2) == ratio(1, 100));
}

TEST_CASE("the decimal exponent is that of the power of ten at or below the magnitude") {
  CHECK(decimal_exponent(1) == 0);
  CHECK(decimal_exponent(ratio(999, 100)) == 0);
  CHECK(decimal_exponent(10) == 1);
  CHECK(decimal_exponent(ratio(-1, 10)) == -1);
  CHECK(decimal_exponent(ratio(99999, 1000000)) == -2);
  for (const long e : {-700L, -45L, 0L, 15L, 400L}) {
    CHECK(decimal_exponent(ten_to(e)) == e);
    CHECK(decimal_exponent(Rational(ten_to(e) * ratio(999999, 1000000))) == e - 1);
  }
}

} // namespace decimal_exponent_test
