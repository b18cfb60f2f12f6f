#include "catch.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <random>

namespace decimal_test {

using namespace mdm;

TEST_CASE("a decimal is read exactly") {
  CHECK(parse_decimal("3.86") == ratio(193, 50));
  CHECK(parse_decimal("-0.25") == ratio(-1, 4));
  CHECK(parse_decimal("+.5") == ratio(1, 2));
  CHECK(parse_decimal("5.") == 5);
  CHECK(parse_decimal("1.2e3") == 1200);
  CHECK(parse_decimal("1E-3") == ratio(1, 1000));
  CHECK(parse_decimal("0000000000000000000000000000001.50") == ratio(3, 2));
  CHECK(parse_decimal("0,075", ',') == ratio(3, 40));
  CHECK(parse_decimal("0.1234567890123456789012345") * Rational(power_of_ten(25)) ==
        Rational(Integer("1234567890123456789012345")));
  CHECK(parse_decimal("1e400") == Rational(power_of_ten(400)));
  CHECK(parse_decimal("-0") == 0);
}

TEST_CASE("what is no decimal is refused") {
  for (const char *text : {"", ".", "-", "+-1", "1 2", "1.2.3", "0x10", "nan", "inf", "1e", "1e+", "1,5",
                           "12a", "e5", "1e401", "1e-401", "1e999999999", "1e99999999999999999999", "\xff"})
    CHECK_THROWS_AS(parse_decimal(text), InputError);
  CHECK_NOTHROW(parse_decimal(std::string(1000, '7')));
  CHECK_THROWS_AS(parse_decimal(std::string(1001, '7')), InputError);
}

TEST_CASE("a decimal is printed exactly and read back") {
  CHECK(to_decimal(ratio(19, 500)) == "0.038");
  CHECK(to_decimal(ratio(-7, 4)) == "-1.75");
  CHECK(to_decimal(1200) == "1200");
  CHECK(to_decimal(0) == "0");
  CHECK_FALSE(exact_decimal(ratio(1, 3)).has_value());
  CHECK_FALSE(exact_decimal(ratio(1, power(Integer(7), 40))).has_value());
  std::mt19937_64 random(1);
  for (int i = 0; i < 2000; ++i) {
    const Integer digits = Integer(random()) * (i % 2 == 0 ? Integer(1) : Integer(random()));
    const unsigned places = static_cast<unsigned>(random() % 60);
    const Rational r = ratio(digits, power_of_ten(places));
    CHECK(parse_decimal(to_decimal(r)) == r);
    CHECK(decimal_string(digits, places) == to_decimal(r));
  }
}

TEST_CASE("an approximation is cut, not rounded") {
  CHECK(approximate(ratio(2, 3), 3) == "0.666");
  CHECK(approximate(ratio(1999, 1), 2) == "1900");
  CHECK(approximate(ratio(1, 3000000000), 3) == "3.33e-10");
  CHECK(approximate(ratio(-1, 8), 2) == "-0.12");
  CHECK(approximate(1, 5) == "1");
  CHECK(approximate(power_of_ten(9), 3) == "1000000000");
}

} // namespace decimal_test
