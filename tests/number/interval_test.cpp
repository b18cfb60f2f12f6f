#include "catch.hpp"

#include <mdm/number/interval.hpp>

namespace interval_test {

using namespace mdm;

TEST_CASE("Interval: operations hold every value") {
  const Interval y(ratio(-1, 2), 3), z(1, 2);
  CHECK((y + z).lo == ratio(1, 2));
  CHECK((y + z).hi == 5);
  CHECK((y - z).lo == ratio(-5, 2));
  CHECK((y - z).hi == 2);
  CHECK((z * Interval(3, 5)).lo == 3);
  CHECK((z * Interval(3, 5)).hi == 10);
  CHECK(power(z, 3).lo == 1);
  CHECK(power(z, 3).hi == 8);
  CHECK(absolute(y).lo == 0);
  CHECK(absolute(y).hi == 3);
  CHECK(absolute(Interval(-3, -1)).lo == 1);
  CHECK(absolute(z).hi == 2);
  CHECK(greater(y, z).lo == 1);
  CHECK(greater(y, z).hi == 3);
  CHECK(Interval(2).is_point());
  CHECK_FALSE(z.is_point());
}

TEST_CASE("Interval: roots are exact or close on both sides") {
  CHECK(root(ratio(8, 27), 3, 10).is_point());
  CHECK(root(ratio(8, 27), 3, 10).lo == ratio(2, 3));
  for (const unsigned degree : {2U, 3U, 7U}) {
    const Interval y = root(ratio(5, 3), degree, 100);
    CHECK(power(y.lo, degree) < ratio(5, 3));
    CHECK(power(y.hi, degree) > ratio(5, 3));
    CHECK(y.hi - y.lo == power(ratio(1, 2), 100));
  }
}

} // namespace interval_test
