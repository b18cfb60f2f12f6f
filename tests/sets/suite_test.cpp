// Suites that a description and a seed make: what each kind of line must be, and descriptions that are
// refused.

#include "catch.hpp"
#include "sets/suite.hpp"

#include <mdm/gradation/write_gradation.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <numeric>
#include <set>

namespace suite_test {

using namespace mdm;

namespace {

std::string described(const std::string &sieves, const std::string &masses, const std::string &more = "") {
  return R"({"schema": "mdm-suite-1", "sieves": {)" + sieves + R"(}, "masses": {)" + masses + "}" + more +
         "}";
}

const std::string iso = R"("series": "ISO R20/3", "from": "0.063", "to": "31.5")";
const std::string random_kind = R"("kind": "random")";

Suite suite_of(const std::string &description) {
  return Suite(description, "suite.json");
}

Rational total(const Gradation &g) {
  return std::accumulate(g.masses().begin(), g.masses().end(), Rational(0));
}

std::string refusal(const std::string &description) {
  try {
    suite_of(description);
  } catch (const InputError &e) {
    return e.what();
  }
  return "";
}

} // namespace

TEST_CASE("a line depends on its number and the seed alone", "[suite]") {
  const Suite suite = suite_of(described(iso, random_kind, R"(, "classes": [2, 9])"));
  const Gradation first = suite.line(7, 1);
  CHECK(suite.line(8, 1).masses() != first.masses());
  CHECK(suite.line(7, 2).masses() != first.masses());
  CHECK(suite.line(7, 1).masses() == first.masses());
  CHECK(suite.line(7, 1).sizes() == first.sizes());
  CHECK(first.id() == "g-7");
  CHECK(suite.line(18446744073709551615U, 1).id() == "g-18446744073709551615");
}

TEST_CASE("the sieves are of the series, and as many classes as asked for come, each number of them",
          "[suite]") {
  const Suite suite = suite_of(described(iso, random_kind, R"(, "classes": [2, 5])"));
  const Gradation all = suite_of(described(iso, random_kind)).line(1, 1);
  REQUIRE(all.classes() == 18); // 63, 90 um, ..., 31.5 mm
  CHECK(all.sizes().front() == ratio(63, 1000));
  CHECK(all.sizes().back() == ratio(315, 10));
  std::set<std::size_t> numbers;
  std::set<Rational> openings;
  for (std::uint64_t n = 1; n <= 200; ++n) {
    const Gradation g = suite.line(n, 3);
    numbers.insert(g.classes());
    openings.insert(g.sizes().begin(), g.sizes().end());
    CHECK(std::includes(all.sizes().begin(), all.sizes().end(), g.sizes().begin(), g.sizes().end()));
  }
  CHECK(numbers == std::set<std::size_t>{2, 3, 4, 5});
  CHECK(openings.size() == 19);
}

TEST_CASE("neighbours follow each other in the series", "[suite]") {
  const Suite suite = suite_of(
      described(R"("list": [8, 4, 2, 1, 16, 32], "neighbours": true)", random_kind, R"(, "classes": 3)"));
  std::set<Rational> first;
  for (std::uint64_t n = 1; n <= 50; ++n) {
    const Gradation g = suite.line(n, 1);
    REQUIRE(g.classes() == 3);
    first.insert(g.sizes().front());
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(g.upper(i) == 2 * g.lower(i));
  }
  CHECK(first == std::set<Rational>{1, 2, 4});
}

TEST_CASE("shares are multiples of their last digit, above 0, and sum to 100", "[suite]") {
  const Suite suite = suite_of(described(iso, random_kind, R"(, "digits": 2)"));
  for (std::uint64_t n = 1; n <= 50; ++n) {
    const Gradation g = suite.line(n, 1);
    CHECK(total(g) == 100);
    for (std::size_t j = 0; j < g.classes(); ++j)
      CHECK((g.mass(j) >= 1 && denominator(g.mass(j)) == 1));
  }
  const Suite fine = suite_of(described(iso, random_kind, R"(, "digits": 40)"));
  CHECK(total(fine.line(1, 1)) == 100);
  CHECK(denominator(fine.line(1, 1).mass(0)) > power_of_ten(30));
}

TEST_CASE("a gap is a run of inner classes", "[suite]") {
  const Suite suite =
      suite_of(described(iso, R"("kind": "gap-graded", "empty": [1, 3])", R"(, "classes": [5, 8])"));
  std::set<std::ptrdiff_t> lengths;
  for (std::uint64_t n = 1; n <= 100; ++n) {
    const Gradation g = suite.line(n, 1);
    std::vector<Rational> masses(g.masses().begin(), g.masses().end() - 1);
    CHECK(total(g) == 100);
    const auto first = std::find(masses.begin(), masses.end(), Rational(0));
    const auto end = std::find_if(first, masses.end(), [](const Rational &m) { return m != 0; });
    CHECK(first != masses.begin());
    CHECK(end != masses.end());
    CHECK(std::count(end, masses.end(), Rational(0)) == 0);
    lengths.insert(end - first);
  }
  CHECK(lengths == std::set<std::ptrdiff_t>{1, 2, 3});
}

TEST_CASE("a beta curve with whole parameters has the shares of its polynomial", "[suite]") {
  // 1 - (1 - x)^2 at 1/4, 1/2, 3/4: 7/16, 3/4, 15/16; to three digits 0.4375 goes up and 0.9375, too.
  const Suite suite = suite_of(
      described(R"("list": [1, 2, 3, 4, 5])", R"("kind": "beta", "a": 1, "b": 2)", R"(, "digits": 3)"));
  CHECK(suite.line(1, 1).masses() ==
        std::vector<Rational>{ratio(438, 10), ratio(312, 10), ratio(188, 10), ratio(62, 10), 0});
}

TEST_CASE("a lognormal curve about the middle is symmetric on the log scale", "[suite]") {
  const Suite suite = suite_of(described(R"("list": [1, 2, 4, 8, 16])",
                                         R"("kind": "lognormal", "median": 0.5, "deviation": 0.693147)"));
  const Gradation g = suite.line(1, 1);
  CHECK(total(g) == 100);
  CHECK(g.mass(0) == g.mass(3));
  CHECK(g.mass(1) == g.mass(2));
  // The normal distribution between one deviation and two, of that within two: 0.1359051 / 0.9544997.
  CHECK(g.mass(0) == ratio(142384, 10000));
}

TEST_CASE("a normal distribution about the middle is symmetric over the classes, whatever their widths",
          "[suite]") {
  const Suite suite = suite_of(
      described(R"("list": [1, 2, 5, 10, 100])", R"("kind": "normal", "centre": 0.5, "deviation": 1)"));
  const Gradation g = suite.line(1, 1);
  CHECK(total(g) == 100);
  CHECK(g.mass(0) == g.mass(3));
  CHECK(g.mass(1) == g.mass(2));
  // e^(-9/8) / (2 e^(-9/8) + 2 e^(-1/8)) = 0.13447...
  CHECK(abs(Rational(g.mass(0) - ratio(134471, 10000))) <= ratio(1, 10000));
}

TEST_CASE("noise is added to normal masses, and differs from line to line", "[suite]") {
  const Suite suite = suite_of(described(
      iso, R"("kind": "normal", "centre": 0.5, "deviation": 0.25, "noise": 0.5)", R"(, "classes": 8)"));
  for (std::uint64_t n = 1; n <= 20; ++n) {
    const Gradation g = suite.line(n, 3);
    CHECK(total(g) == 100);
    // Without noise the outermost classes have 3e-42 of the height: it is all noise.
    CHECK(g.mass(0) < 50);
    CHECK(g.mass(0) != suite.line(n + 1, 3).mass(0));
  }
}

TEST_CASE("tied masses are those of whole numbers of particles at the sieves", "[suite]") {
  const Suite suite =
      suite_of(described(iso, R"("kind": "ties", "quantities": [2, 5], "at": "upper", "law": "power:2")"));
  for (std::uint64_t n = 1; n <= 20; ++n) {
    const Gradation g = suite.line(n, 1);
    for (std::size_t j = 0; j < g.classes(); ++j) {
      const Rational q = g.mass(j) / power(g.upper(j), 2);
      CHECK((denominator(q) == 1 && q >= 2 && q <= 5));
    }
  }
}

TEST_CASE("geometric sieves begin and end where they should, to their digits", "[suite]") {
  const Gradation g =
      suite_of(described(R"("from": 1, "to": 10, "digits": 5)", random_kind, R"(, "classes": 3)")).line(1, 1);
  CHECK(g.sizes() == std::vector<Rational>{1, ratio(21544, 10000), ratio(46416, 10000), 10});
  const Gradation narrow = suite_of(described(R"("from": 1, "ratio": "1.000000000001", "digits": 20)",
                                              random_kind, R"(, "classes": 2)"))
                               .line(1, 1);
  CHECK(narrow.upper(0) - narrow.lower(0) == ratio(1, power_of_ten(12)));
}

TEST_CASE("half-phi sieves are rounded to 15 digits", "[suite]") {
  const Gradation g =
      suite_of(described(R"("series": "half-phi", "from": 0.9, "to": 2)", random_kind, R"(, "unit": "um")"))
          .line(1, 1);
  REQUIRE(g.sizes().size() == 3);
  CHECK(g.lower(1) - g.lower(0) < ratio(1, 2));
  const Gradation mm =
      suite_of(described(R"("series": "half-phi", "from": 1, "to": 2)", random_kind)).line(1, 1);
  CHECK(mm.sizes() == std::vector<Rational>{1, ratio(Integer("141421356237310"), power_of_ten(14)), 2});
}

TEST_CASE("lines at the bounds of all numbers can be written", "[suite]") {
  const Suite suite = suite_of(described(R"("from": "1e-30", "to": "1e30", "digits": 100)",
                                         R"("kind": "ties", "quantities": 999999999, "law": "power:9")",
                                         R"(, "classes": 20)"));
  CHECK_FALSE(gradation_json(suite.line(1, 1)).empty());
}

TEST_CASE("a list of kinds has all of them", "[suite]") {
  const Suite suite = suite_of(R"({"schema": "mdm-suite-1", "id": "both", "sieves": {"list": [1, 2, 4, 8]},
    "masses": [{"kind": "ties", "quantities": 1}, {"kind": "gap-graded"}]})");
  bool has_tie = false, has_gap = false;
  for (std::uint64_t n = 1; n <= 50; ++n)
    (suite.line(n, 1).mass(1) == 0 ? has_gap : has_tie) = true;
  CHECK(has_tie);
  CHECK(has_gap);
}

TEST_CASE("nonsense is refused with the member that is wrong", "[suite]") {
  const auto has = [](const std::string &description, const std::string &part) {
    INFO(description << "\n" << refusal(description));
    CHECK(refusal(description).find(part) != std::string::npos);
  };
  has("", "suite.json:1: this is not JSON");
  has("[]", "suite.json: the description is no object");
  has("{}", "schema: is missing");
  has(R"({"schema": "mdm-suite-2"})", "schema: 'mdm-suite-2' is none of mdm-suite-1");
  has(R"({"schema": "mdm-suite-1"})", "sieves: is missing");
  has(R"({"schema": "mdm-suite-1", "sieves": [1, 2]})", "sieves is no object");
  has(R"({"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}})", "masses: is missing");
  has(described("", random_kind), "sieves: from: is missing");
  has(described(R"("from": 1)", random_kind), "sieves: to: is missing");
  has(described(R"("list": 7)", random_kind), "sieves: list: is no list");
  has(described(R"("list": [1])", random_kind), "sieves: 1 of them: give from 2");
  has(described(R"("list": [1, 1])", random_kind), "an opening is there twice");
  has(described(R"("list": [0, 1])", random_kind), "'0' is not above 0");
  has(described(R"("list": [1, "x"])", random_kind), "sieves: list: ");
  has(described(R"("list": [1, true])", random_kind), "'true' is no number");
  has(described(R"("series": "ISO")", random_kind), "'ISO' is no series of sieves");
  has(described(R"("series": "phi", "from": 100, "to": 101)", random_kind), "sieves: 0 of them");
  has(described(R"("list": [1, 2], "neighbors": true)", random_kind), "did you mean neighbours?");
  has(described(R"("list": [1, 2], "neighbours": 1)", random_kind), "'1' is neither true nor false");
  has(described(iso, random_kind, R"(, "classes": 19)"), "classes: '19' is not from 1 to 18");
  has(described(iso, random_kind, R"(, "classes": [5, 2])"), "upside down");
  has(described(iso, random_kind, R"(, "classes": 2.5)"), "write whole numbers");
  has(described(iso, random_kind, R"(, "classes": {})"), "is neither a number nor [from, to]");
  has(described(R"("from": 1, "to": 2)", random_kind), "classes: is missing");
  has(described(R"("from": 1, "to": 2)", random_kind, R"(, "classes": 1001)"), "is not from 1 to 1000");
  has(described(R"("from": 2, "to": 1)", random_kind, R"(, "classes": 2)"), "two of them may be the same");
  has(described(R"("from": 1, "to": 1.1, "digits": 3)", random_kind, R"(, "classes": 20)"),
      "give more digits");
  has(described(R"("from": 1, "ratio": 1)", random_kind, R"(, "classes": 2)"), "two of them may be the same");
  has(described(R"("from": 1, "ratio": 1000)", random_kind, R"(, "classes": 11)"), "beyond 1e30");
  has(described(R"("list": [1, "1e31"])", random_kind), "list: an opening is not from 1e-30 to 1e30");
  has(described(R"("list": [1, ")" + std::string(101, '2') + R"("])", random_kind),
      "longer than 100 characters");
  has(described(iso, R"("kind": "ties", "law": "power:10")"), "'power:10' is beyond x^9");
  has(described(iso, random_kind, R"(, "digits": 0)"), "digits: '0' is not from 1 to 100");
  has(described(iso, random_kind, R"(, "digits": 1)"), "1 are too few for 18 classes");
  has(described(iso, random_kind, R"(, "digits": [1, 2])"), "write one number");
  has(described(iso, random_kind, R"(, "id": "")"), "id: write 1 to 100 characters");
  has(described(iso, random_kind, R"(, "id": "a\u0007")"), "id: it has characters that cannot be printed");
  has(described(iso, random_kind, R"(, "unit": "in")"), "unit: 'in' is none of mm, um, m");
  has(described(iso, random_kind, R"(, "clases": 3)"), "'clases' is not known here: did you mean classes?");
  has(described(iso, R"("kind": "rand")"), "masses: kind: 'rand' is none of random, gap-graded");
  has(described(iso, R"("kind": "random", "a": 1)"), "masses: 'a' is not known here");
  has(described(iso, R"("kind": "beta", "a": 0, "b": 1)"), "masses: a: '0' is not from 0.001 to 1000");
  has(described(iso, R"("kind": "beta", "a": 1)"), "masses: b: is missing");
  has(described(iso, R"("kind": "lognormal", "median": 2, "deviation": 1)"),
      "median: '2' is not from 0 to 1");
  has(described(iso, R"("kind": "lognormal", "median": 0.5, "deviation": 0)"), "deviation: '0' is not from");
  has(described(iso, R"("kind": "normal", "deviation": 0.2)"), "deviation: '0.2' is not from");
  has(described(iso, R"("kind": "normal")"), "deviation: is missing");
  has(described(iso, R"("kind": "normal", "deviation": 1, "noise": -1)"), "noise: '-1' is not");
  has(described(iso, R"("kind": "gap-graded")", R"(, "classes": 2)"), "a gap needs at least 3 classes");
  has(described(iso, R"("kind": "gap-graded", "empty": 4)", R"(, "classes": [5, 9])"), "is not from 1 to 3");
  has(described(iso, R"("kind": "ties", "law": "power:5/2")"), "has irrational masses");
  has(described(iso, R"("kind": "ties", "at": "middle")"), "at: 'middle' is none of upper, lower, either");
  has(R"({"schema": "mdm-suite-1", "sieves": {"list": [1, 2]}, "masses": []})", "the list is empty");
}

} // namespace suite_test
