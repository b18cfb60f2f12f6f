#include "catch.hpp"
#include "number/int128.hpp"

#include <mdm/number/rational.hpp>

#include <random>

namespace rational_test {

using namespace mdm;

namespace {

/// An integer of random length up to 140 bits, often at the edge of a machine word.
Integer random_integer(std::mt19937_64 &random) {
  const unsigned edges[] = {0, 1, 31, 53, 63, 64, 126, 127};
  Integer n = Integer(1) << edges[random() % 8];
  if (random() % 2 == 0)
    n = n * Integer(random() >> (random() % 64));
  n += static_cast<long>(random() % 3) - 1;
  return random() % 2 == 0 ? n : Integer(-n);
}

} // namespace

TEST_CASE("division rounds down and up, for either sign") {
  CHECK(floor_div(-7, 2) == -4);
  CHECK(ceil_div(-7, 2) == -3);
  CHECK(floor(ratio(-7, 2)) == -4);
  CHECK(ceil(ratio(7, 2)) == 4);
  CHECK(floor(ratio(6, 3)) == 2);
  // A cast through double would lose this one.
  const Integer big = (Integer(1) << 70) + 1;
  CHECK(floor(ratio(big * 3 + 2, 3)) == big);
}

TEST_CASE("a floor root is the largest") {
  std::mt19937_64 random(2);
  for (int i = 0; i < 2000; ++i) {
    const Integer n = abs(random_integer(random));
    const unsigned degree = 1 + static_cast<unsigned>(random() % 7);
    const Integer y = floor_root(n, degree);
    CHECK(power(y, degree) <= n);
    CHECK(n < power(Integer(y + 1), degree));
  }
}

TEST_CASE("an exact root is found if there is one") {
  CHECK(exact_root(ratio(8, 27), 3) == ratio(2, 3));
  CHECK_FALSE(exact_root(ratio(8, 26), 3).has_value());
  CHECK_FALSE(exact_root(2, 2).has_value());
}

TEST_CASE("the simplest fraction between two bounds has the least denominator, then the least numerator") {
  for (int n1 = 1; n1 < 14; ++n1)
    for (int d1 = 1; d1 < 14; ++d1)
      for (int n2 = 1; n2 < 14; ++n2)
        for (int d2 = 1; d2 < 14; ++d2) {
          if (n1 * d2 > n2 * d1)
            continue;
          Rational least;
          for (int d = 1; least == 0; ++d) {
            const int n = (n1 * d + d1 - 1) / d1;
            if (n * d2 <= n2 * d)
              least = ratio(n, d);
          }
          REQUIRE(simplest_between(ratio(n1, d1), ratio(n2, d2)) == least);
        }
}

TEST_CASE("checked 128-bit integers agree with Integer or say that they overflow") {
  std::mt19937_64 random(3);
  const Integer limit = Integer(1) << 127;
  const auto compare = [&](const Integer &expected, const auto &compute) {
    try {
      const Integer result = compute().to_integer();
      CHECK(result == expected);
    } catch (const Int128Overflow &) {
      CHECK((expected >= limit || expected < -limit));
    }
  };
  for (int i = 0; i < 20000; ++i) {
    const Integer x = random_integer(random) >> (random() % 100);
    const Integer y = random_integer(random) >> (random() % 100);
    if (bit_length(x) > 126 || bit_length(y) > 126) {
      CHECK_THROWS_AS(Int128(bit_length(x) > 126 ? x : y), Int128Overflow);
      continue;
    }
    const Int128 a(x), b(y);
    CHECK(a.to_integer() == x);
    compare(x + y, [&] { return a + b; });
    compare(x * y, [&] { return a * b; });
    CHECK((a < b) == (x < y));
    CHECK((a == b) == (x == y));
    if (x >= 0 && y > 0)
      CHECK(floor_div(a, b).to_integer() == floor_div(x, y));
  }
}

} // namespace rational_test
