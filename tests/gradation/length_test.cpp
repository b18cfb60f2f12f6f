#include "gradation/length.hpp"
#include "support.hpp"

namespace length_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Rational micrometres(const std::string &text) {
  return parse_length(text).in(SizeUnit::um);
}

} // namespace

TEST_CASE("length: a unit is taken exactly") {
  CHECK(micrometres("63um") == 63);
  CHECK(micrometres("63 um") == 63);
  CHECK(micrometres("63\u00b5m") == 63);
  CHECK(micrometres("63\u03bcm") == 63);
  CHECK(micrometres("0.063mm") == 63);
  CHECK(micrometres("2m") == 2000000);
  CHECK(micrometres("2e-3m") == 2000);
  CHECK(micrometres("0.375in") == 9525);
  CHECK(parse_length("0.375in").in(SizeUnit::m) == ratio(9525, 1000000));
  CHECK(parse_length("3cm").in(SizeUnit::mm) == 30);
  CHECK(parse_length("0.5 cm").in(SizeUnit::m) == ratio(5, 1000));
}

TEST_CASE("length: without a unit a number is in the unit of the file") {
  CHECK_FALSE(parse_length("63").unit);
  CHECK(micrometres("63") == 63);
  CHECK(parse_length("63").in(SizeUnit::m) == 63);
  CHECK(parse_length("1e3").in(SizeUnit::mm) == 1000);
}

TEST_CASE("length: what is none is refused") {
  for (const char *text :
       {"", "mm", "0", "0mm", "-1mm", "x", "1 x", "1e", "1/2in", "1mm2", "3  mm", "1,5mm"}) {
    INFO(text);
    CHECK_THROWS_AS(parse_length(text), InputError);
  }
  CHECK(message_of([] { parse_length("3km"); }) ==
        "'3km': 'km' is no unit that is known: write mm, cm, um, m or in, or the number alone");
  CHECK(contains(message_of([] { parse_length("-1mm"); }), "is not positive"));
}

} // namespace length_test
