#include "catch.hpp"
#include "number/pi.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/number/enclosure.hpp>

#include <mpfr.h>

#include <random>

namespace enclosure_test {

using namespace mdm;

TEST_CASE("a root enclosure holds the root, one unit wide, with the digits that were asked for") {
  std::mt19937_64 random(4);
  for (int i = 0; i < 5000; ++i) {
    const Integer n =
        1 + (Integer(random()) >> (random() % 64)) * (i % 3 == 0 ? Integer(random()) : Integer(1));
    const Integer d =
        1 + (Integer(random()) >> (random() % 64)) * (i % 5 == 0 ? Integer(random()) : Integer(1));
    const unsigned degree = 1 + static_cast<unsigned>(random() % 6);
    const unsigned digits = 1 + static_cast<unsigned>(random() % 40);
    const Enclosure x = enclose_root(n, d, degree, digits);
    if (x.lo == x.hi) {
      CHECK(power(x.lower(), degree) == ratio(n, d));
      continue;
    }
    CHECK(x.hi == x.lo + 1);
    CHECK(power(x.lower(), degree) < ratio(n, d));
    CHECK(ratio(n, d) < power(x.upper(), degree));
    const std::size_t length = to_string(x.lo).size();
    CHECK((length == digits || (length > digits && x.places == 0)));
  }
}

TEST_CASE("a root that is a decimal is a point, however long") {
  CHECK(enclose_root(27, 8, 3, 1).text() == "1.5");
  CHECK(enclose_root(2 * 27, 2 * 8, 3, 15).text() == "1.5");
  const Rational x = parse_decimal("0.12345678901234567890123456789");
  const Rational cube = power(x, 3);
  CHECK(enclose_root(numerator(cube), denominator(cube), 3, 5).lower_text() ==
        "0.12345678901234567890123456789");
  const Enclosure third = enclose_root(1, 27, 3, 4);
  CHECK(third.text() == "[0.3333, 0.3334]");
  CHECK(enclose_root(power_of_ten(300), 1, 3, 3).text() == "1" + std::string(100, '0'));
}

namespace {

/// floor(10^places (n/d)^(1/3)), by GMP's root.
Integer cube_root(const Integer &n, const Integer &d, unsigned places) {
  const Integer scaled = n * power(power_of_ten(places), 3) / d;
  Integer root;
  mpz_root(root.backend().data(), scaled.backend().data(), 3);
  return root;
}

} // namespace

TEST_CASE("cube roots are those of integers, whatever doubles decide") {
  std::mt19937_64 random(17);
  const auto number = [&random](unsigned bits) {
    Integer n = random();
    while (bit_length(n) < bits)
      n = (n << 64) + Integer(random());
    return Integer((n >> (bit_length(n) - bits)) + 1);
  };
  for (int i = 0; i < 20000; ++i) {
    const auto bits = static_cast<unsigned>(1 + random() % 250);
    const Integer n = number(bits);
    const Integer d = number(static_cast<unsigned>(1 + random() % 250));
    const Enclosure x = enclose_root(n, d, 3, static_cast<unsigned>(1 + random() % 32));
    CHECK(x.lo == cube_root(n, d, x.places));
  }
}

TEST_CASE("cube roots next to a decimal, or one themselves, are told apart") {
  std::mt19937_64 random(18);
  for (int i = 0; i < 3000; ++i) {
    const auto places = static_cast<unsigned>(1 + random() % 24);
    const Integer decimal = 1 + Integer(random()) * (i % 2 == 0 ? Integer(1) : Integer(random()));
    const Integer unit = power(power_of_ten(places), 3) * (1 + random() % 1000);
    const Integer cube = power(decimal, 3) * (unit / power(power_of_ten(places), 3));
    const auto digits = static_cast<unsigned>(1 + random() % 30);
    const Enclosure exact = enclose_root(cube, unit, 3, digits);
    CHECK(exact.lo == exact.hi);
    CHECK(exact.lower() == ratio(decimal, power_of_ten(places)));
    for (const int change : {-1, 1}) {
      const Integer n = cube + change;
      if (n == 0)
        continue;
      const Enclosure x = enclose_root(n, unit, 3, digits);
      CHECK(x.lo == cube_root(n, unit, x.places));
    }
  }
}

TEST_CASE("an interval is rounded outwards") {
  CHECK(enclose_interval(1, 1, 3, 3).text() == "[0.333, 0.334]");
  CHECK(enclose_interval(1, 2, 3, 2).text() == "[0.33, 0.67]");
  CHECK(enclose_interval(5, 5, 10, 3).text() == "0.5");
}

TEST_CASE("pi is enclosed, as MPFR has it") {
  for (const unsigned places : {1U, 10U, 50U, 333U}) {
    const Enclosure pi = enclose_pi(places);
    CHECK(pi.hi == pi.lo + 1);
    mpfr_t reference, scale;
    mpfr_init2(reference, 2000);
    mpfr_init2(scale, 2000);
    mpfr_const_pi(reference, MPFR_RNDD);
    mpfr_ui_pow_ui(scale, 10, places, MPFR_RNDN);
    mpfr_mul(reference, reference, scale, MPFR_RNDD);
    Integer floor;
    mpfr_get_z(floor.backend().data(), reference, MPFR_RNDD);
    CHECK(floor == pi.lo);
    mpfr_clear(reference);
    mpfr_clear(scale);
  }
}

} // namespace enclosure_test
