#include "gradation/mass_digits.hpp"
#include "support.hpp"

#include <charconv>

namespace mass_digits_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Rational r(const std::string &text) {
  return parse_decimal(text);
}

/// What a program prints of a double so that it reads back.
std::string printed(double x) {
  std::array<char, 32> text{};
  const auto [end, error] =
      std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed);
  REQUIRE(error == std::errc());
  return {text.data(), end};
}

} // namespace

TEST_CASE("Significant digits: the nearest, a half away from zero") {
  CHECK(to_digits(r("0.30000000000000004"), 15) == r("0.3"));
  CHECK(to_digits(r("12.345"), 4) == r("12.35"));
  CHECK(to_digits(r("-12.345"), 4) == r("-12.35"));
  CHECK(to_digits(r("12.3449"), 4) == r("12.34"));
  CHECK(to_digits(r("99.96"), 3) == r("100"));
  CHECK(to_digits(r("123456"), 2) == r("120000"));
  CHECK(to_digits(r("1e-400"), 3) == r("1e-400"));
  CHECK(to_digits(r("9.96e399"), 2) == r("1e400"));
  CHECK(to_digits(0, 3) == 0);
  for (const std::string power : {"1e-400", "0.001", "1", "1000", "1e400"})
    CHECK(to_digits(r(power), 1) == r(power));
}

TEST_CASE("The unit of a last digit") {
  CHECK(digit_unit(r("99.96"), 3) == r("0.1"));
  CHECK(digit_unit(r("100"), 3) == 1);
  CHECK(digit_unit(0, 3) == 0);
}

TEST_CASE("Prints of doubles beside short decimals are noted with both") {
  const std::optional<std::string> note = float_dust_note({r("0.30000000000000004"), r("0.3"), r("99.4")});
  REQUIRE(note);
  CHECK(*note ==
        "Masses look like floating point: '0.30000000000000004 beside 0.3'. They are taken as written; "
        "--round 15 takes the short ones.");
  CHECK(contains(*float_dust_note({r("0.9999999999999999"), 0}), "0.9999999999999999 beside 1"));
}

TEST_CASE("Differences of percents in doubles are all noticed, and the digits of the note mend them") {
  for (int hundredths = 1; hundredths < 10000; hundredths += 7) {
    const double difference = 100.0 - hundredths / 100.0;
    const double passing = difference - (difference - 0.01);
    const Rational mass = r(printed(passing));
    if (mass == r("0.01"))
      continue;
    INFO(printed(passing));
    const std::optional<std::string> note = float_dust_note({mass, 50});
    REQUIRE(note);
    const std::size_t at = note->find("--round ") + 8;
    CHECK(to_digits(mass, static_cast<unsigned>(std::stoul(note->substr(at)))) == r("0.01"));
  }
}

TEST_CASE("The note on rounded values says which were rounded") {
  std::vector<Rational> values = {r("12.3"), r("45.6")};
  CHECK(settle_digits(values, 2) == "All masses were taken to 2 significant digits.");
  CHECK(values == std::vector<Rational>{12, 46});
  CHECK(settle_digits(values, 1, "percent passing") ==
        "All percent passing values were taken to 1 significant digit; classes have their differences.");
}

TEST_CASE("Long decimals that stand beside no short one are left alone") {
  CHECK_FALSE(float_dust_note({r("0.1234567890123456"), r("33.33333333333333"), r("0.3"), 100}));
  CHECK_FALSE(float_dust_note({ratio(1, 3), 0}));
  CHECK_FALSE(float_dust_note({r("0.30000000000000000004"), 1})); // of no double
  CHECK_FALSE(float_dust_note({}));
}

TEST_CASE("Digits that give the whole") {
  CHECK(digits_that_give(r("0.9999999999999999"), 1) == 15U);
  CHECK(digits_that_give(r("99.99"), 100) == 3U);
  CHECK_FALSE(digits_that_give(r("99.9"), 100));
  CHECK_FALSE(digits_that_give(r("93.4"), 100));
}

} // namespace mass_digits_test
