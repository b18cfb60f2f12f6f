// Arithmetic with one root is exact and tells fractions.

#include "catch.hpp"
#include "number/surd.hpp"

namespace surd_test {

using namespace mdm;

namespace {

Surd root(int r, unsigned n, unsigned degree) {
  return Surd::root_power(r, n, degree);
}

} // namespace

TEST_CASE("roots are reduced to the field that they span") {
  CHECK(root(100, 5, 10).exact() == Rational(10));
  CHECK_FALSE(root(100, 4, 10).exact());
  CHECK(root(100, 1, 10).degree() == 5); // 10^(1/5)
  CHECK(root(7, 3, 12).degree() == 12);
  CHECK(root(16, 1, 4).exact() == Rational(2));
  CHECK(root(4, 1, 4).degree() == 2);
}

TEST_CASE("sums and products are exact") {
  const Surd t = root(2, 1, 3);
  CHECK((t * t * t).exact() == Rational(2));
  CHECK(power(t, 30).exact() == Rational(1024));
  CHECK(((t + Surd(1)) * (t * t - t + Surd(1))).exact() == Rational(3)); // t^3 + 1
  CHECK((t - t).exact() == Rational(0));
  CHECK_FALSE((t * t + t).exact());
  CHECK((inverse(Surd(3) * t * t) * t * t).exact() == ratio(1, 3));
  CHECK(inverse(Surd(4)).exact() == ratio(1, 4));
}

TEST_CASE("the value is enclosed") {
  const Real y = (root(2, 1, 2) * Surd(3) + Surd(1)).real();
  CHECK(rounded(y, 15) == "5.24264068711929");
  CHECK(Surd(ratio(1, 3)).real().fraction() == ratio(1, 3));
}

TEST_CASE("floors of reals are decided by refining, or with what is known exactly") {
  const Real root_two = root(2, 1, 2).real();
  CHECK(floor_of(root_two * 1000000).lo == 1414213);
  CHECK(floor_of(root_two - 3).hi == -2);
  const Real two = root_two * root_two; // refining alone never ends
  CHECK(floor_of(two).lo == 1);
  CHECK(floor_of(two).hi == 2);
  CHECK(floor_of(two, [](const Integer &k) { return k == 2; }).lo == 2);
  CHECK(floor_of(Real(ratio(7, 2))).is_point());
}

} // namespace surd_test
