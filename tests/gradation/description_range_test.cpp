#include "catch.hpp"
#include "gradation/description.hpp"

namespace description_range_test {

using namespace mdm;

namespace {

/// Classes (1, 2] and (2, 4].
Description description() {
  Gradation::Data d;
  d.sizes = {1, 2, 4};
  d.masses = {1, 8, 0};
  return Description(Gradation(std::move(d)));
}

SizeRange range(const Rational &lo, const Rational &hi, bool is_open = false) {
  return {lo, hi, is_open};
}

} // namespace

TEST_CASE("Particles of which ranges are known have their masses between those of the ends") {
  Description d = description();
  d.add(range(1, ratio(3, 2), true), 2);
  d.add(range(3, 4), 1);
  CHECK(d.particles() == 3);
  CHECK(d.describes());
  CHECK_FALSE(d.knows_sizes());
  CHECK(d.of_class(0).count == 2);
  CHECK(d.of_class(1).count == 1);
  const MatchError e = d.error();
  // masses in [2, 27/4] and [27, 64]
  CHECK(e.as_given[0].lo == 1 - ratio(27, 4));
  CHECK(e.as_given[0].hi == 1 - 2);
  CHECK(e.as_given[1].lo == 8 - 64);
  CHECK(e.as_given[1].hi == 8 - 27);
  CHECK(e.shares[0].lo <= ratio(2, 66));
  CHECK(e.shares[0].hi >= ratio(27, 4) / (ratio(27, 4) + 27));
}

TEST_CASE("A range that is a point is a size") {
  Description d = description(), same = description();
  d.add(range(2, 2), 3);
  same.add(Rational(2), 3);
  CHECK(d.knows_sizes());
  CHECK(d.of_class(0).count == 3);
  CHECK(d.error().maximum.lo == same.error().maximum.lo);
}

TEST_CASE("A range with a sieve in it has no class") {
  Description d = description();
  d.add(range(2, 3), 5); // 2 itself passes the sieve of 2
  CHECK(d.unplaced().count == 5);
  CHECK(d.particles() == 5);
  CHECK(d.of_class(0).count == 0);
  CHECK(d.of_class(1).count == 0);
  const MatchError e = d.error();
  for (const Interval &share : e.shares) {
    CHECK(share.lo == 0);
    CHECK(share.hi >= 1);
  }
  Description open = description();
  open.add(range(2, 3, true), 5);
  CHECK(open.unplaced().count == 0);
  CHECK(open.of_class(1).count == 5);
}

TEST_CASE("Ranges outside all classes are outside") {
  Description d = description();
  d.add(range(ratio(1, 2), 1), 2);
  d.add(range(5, 6), 3);
  d.add(range(4, 5), 1); // 4 is in the class
  CHECK(d.below().count == 2);
  CHECK(d.above().count == 3);
  CHECK(d.unplaced().count == 1);
  CHECK_FALSE(d.describes());
}

} // namespace description_range_test
