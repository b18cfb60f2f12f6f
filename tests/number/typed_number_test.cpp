// Numbers of options: 10000, 1e4 and 10_000 are the same.

#include "catch.hpp"
#include "number/typed_number.hpp"

#include <mdm/text/error.hpp>

namespace typed_number_test {

using namespace mdm;

TEST_CASE("a whole number may have an exponent, and underscores between digits", "[number]") {
  for (const char *text :
       {"10000", "1e4", "1E+4", "10_000", "1_0_0_0_0", "0.1e5", "10000.0", "1_0e0_3", "+1e4"})
    CHECK(parse_typed_natural(text) == Integer(10000));
  CHECK(parse_typed_natural("0") == Integer(0));
  CHECK(parse_typed_natural("1e400") == power(Integer(10), 400));
}

TEST_CASE("what is no whole number from 0 on is nothing", "[number]") {
  for (const char *text :
       {"",      "_",     "1_",   "_1",    "1__0", "1_e4", "1e_4",  "1e",   "1.5",  "1e-1", "-1", "-1e4",
        "1 000", "1,000", "0x10", "1'000", "inf",  "nan",  "1e401", "1._0", "1_.0", "%",    "5%"})
    CHECK_FALSE(parse_typed_natural(text));
}

TEST_CASE("decimals may have underscores between digits", "[number]") {
  CHECK(parse_typed_decimal("1_000.000_5") == ratio(10000005, 10000));
  CHECK(parse_typed_decimal("-5_0e-1_0") == -ratio(50, 10000000000));
  for (const char *text : {"", "1_", "._5", "1_.5", "1.5_", "a_b", "1__000.5"})
    CHECK_THROWS_AS(parse_typed_decimal(text), InputError);
}

} // namespace typed_number_test
