#include "catch.hpp"
#include "soil/bailey.hpp"

#include <algorithm>

namespace bailey_test {

using namespace mdm;

TEST_CASE("Bailey: control sieves are the standard ones nearest to 0.22 times the size before") {
  const std::vector<Rational> standard = {
      ratio(75, 2),  25,          19,           ratio(25, 2), ratio(19, 2), ratio(19, 4), ratio(59, 25),
      ratio(59, 50), ratio(3, 5), ratio(3, 10), ratio(3, 20), ratio(3, 40)};
  const auto nearest = [&standard](const Rational &size) {
    return *std::min_element(standard.begin(), standard.end(), [&size](const Rational &a, const Rational &b) {
      return abs(a - size) < abs(b - size);
    });
  };
  for (const BaileySieves &s : bailey_sieves()) {
    CHECK(s.primary == nearest(s.nominal * ratio(22, 100)));
    CHECK(s.secondary == nearest(s.primary * ratio(22, 100)));
    CHECK(s.tertiary == nearest(s.secondary * ratio(22, 100)));
    // 6.25 mm is no standard sieve, and nearer than any.
    CHECK(s.half == (s.nominal == ratio(25, 2) ? ratio(25, 4) : nearest(s.nominal / 2)));
  }
}

TEST_CASE("Bailey: ratios of what passes") {
  const BaileyRatios r = bailey_ratios({70, 40, 16, 8});
  CHECK(r.coarse == Rational(1));
  CHECK(r.fine_coarse == ratio(2, 5));
  CHECK(r.fine_fine == ratio(1, 2));
  const BaileyRatios none = bailey_ratios({100, 0, 0, 0});
  CHECK_FALSE(none.coarse);
  CHECK_FALSE(none.fine_coarse);
  CHECK_FALSE(none.fine_fine);
}

} // namespace bailey_test
