#include "blend/target_curve.hpp"
#include "catch.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace target_curve_test {

using namespace mdm;

namespace {

std::string passing(const std::string &curve, const std::string &size) {
  return to_decimal(parse_target_curve(curve).passing(parse_decimal(size)));
}

/// True if the curve is refused with that in the message.
bool refuses(const std::string &curve, const std::string &why) {
  try {
    parse_target_curve(curve);
  } catch (const InputError &e) {
    return std::string(e.what()).find(why) != std::string::npos;
  }
  return false;
}

} // namespace

TEST_CASE("computed targets have the digits of Python's decimal with 60 digits, rounded") {
  CHECK(passing("power45:19mm", "0.075") == "8.285876351");
  CHECK(passing("power45:19", "0.3") == "15.461991999");
  CHECK(passing("power45:19000um", "12.5") == "82.826705145");
  CHECK(passing("fuller:31.5mm", "0.063") == "4.472135955");
  CHECK(passing("fuller:31.5mm", "8") == "50.395263068");
  CHECK(passing("andreasen:16mm,q=0.25,dmin=0.063mm", "0.125") == "6.244586865");
  CHECK(passing("andreasen:16mm, q=0.37, dmin=63um", "1") == "26.356729333");
  CHECK(passing("bolomey:31.5mm,a=10", "1") == "26.035674515");
  CHECK(passing("bolomey:31.5mm,a=10", "8") == "55.355736761");
}

TEST_CASE("a computed target is exact where its roots are, and ends at its sizes") {
  CHECK(passing("fuller:16mm", "4") == "50");
  CHECK(passing("fuller:16mm", "0.25") == "12.5");
  CHECK(passing("andreasen:16mm,q=0.5,dmin=1mm", "4") == "33.333333333");
  CHECK(passing("andreasen:16mm,q=0.5,dmin=1mm", "1") == "0");
  CHECK(passing("andreasen:16mm,q=0.5,dmin=1mm", "0.5") == "0");
  CHECK(passing("fuller:16mm", "16") == "100");
  CHECK(passing("fuller:16mm", "17") == "100");
  // Exactly half a unit of the ninth decimal: 1/3 + 2/3 c for c of 5e-12.
  CHECK(passing("andreasen:3mm,q=1,dmin=1mm", "1.00000000001") == "0.000000001");
  CHECK(passing("andreasen:3mm,q=1,dmin=1mm", "1.000000000009") == "0");
}

TEST_CASE("a computed target is a gradation at the sieves of the specification and its largest size") {
  const Envelope limits = {"limits", SizeUnit::mm, {1, 4, 9}, {0, 0, 0}, {100, 100, 100}, {}};
  const Gradation g = gradation_of(parse_target_curve("fuller:16mm"), limits, "fuller:16mm");
  CHECK(g.sizes() == std::vector<Rational>{0, 1, 4, 9, 16});
  CHECK(g.masses() == std::vector<Rational>{25, 25, 25, 25, 0});
  CHECK(g.notes().size() == 1);
  const Envelope in_um = {"limits", SizeUnit::um, {4000, 32000}, {0, 0}, {100, 100}, {}};
  const Gradation finer = gradation_of(parse_target_curve("fuller:16mm"), in_um, "t");
  CHECK(finer.sizes() == std::vector<Rational>{0, 4, 16, 32});
  CHECK(finer.masses() == std::vector<Rational>{50, 50, 0, 0});
}

TEST_CASE("words and files are told apart, and what is no curve is refused") {
  CHECK(names_target_curve("fuller:16mm"));
  CHECK_FALSE(names_target_curve("fuller"));
  CHECK_FALSE(names_target_curve("fuller.csv"));
  CHECK_FALSE(names_target_curve("c:fuller"));
  for (const char *text :
       {"fuller:", "fuller:0mm", "fuller:-3", "fuller:16mm,q=0.4", "bolomey:16mm,a=100", "bolomey:16mm,a=-1",
        "andreasen:16mm", "andreasen:16mm,q=0", "andreasen:16mm,q=11", "andreasen:16mm,q=0.1234",
        "andreasen:16mm,q=0.25,dmin=16mm", "andreasen:16mm,q", "fuller:x"})
    CHECK_THROWS_AS(parse_target_curve(text), InputError);
}

TEST_CASE("a parameter that is given twice, or that is missing, is named") {
  CHECK(refuses("andreasen:16mm,q=0.3,q=0.4,dmin=63um", "'q' has two values: give one"));
  CHECK(refuses("andreasen:16mm,q=0.3,dmin=1mm,dmin=63um", "'dmin' has two values: give one"));
  CHECK(refuses("bolomey:16mm,a=12,a=14", "'a' has two values: give one"));
  CHECK(refuses("bolomey:16mm", "a is missing"));
  CHECK(passing("bolomey:16mm,a=0", "4") == "50");
}

} // namespace target_curve_test
