// Gradations judged by the library's public function.

#include "catch.hpp"

#include <mdm/ask/judge.hpp>
#include <mdm/text/error.hpp>

namespace judge_test {

using namespace mdm;

namespace {

/// 40.0 % pass 1 mm, which stands for 39.95 to 40.05.
UnderstoodGradation report() {
  return understand_gradation("size_mm,passing_percent\n0.5,10.0\n1,40.0\n2,100\n", "sand.csv");
}

Specification at_one(const std::string &least, const std::string &most) {
  return read_specification("size_mm,passing_min_percent,passing_max_percent\n1," + least + "," + most + "\n",
                            "limits.csv");
}

} // namespace

TEST_CASE("a gradation keeps limits, misses them, or hangs on its rounding") {
  CHECK(judge_gradation(report(), at_one("39.95", "41")).verdict == Compliance::holds);
  CHECK(judge_gradation(report(), at_one("40.06", "41")).verdict == Compliance::fails);
  CHECK(judge_gradation(report(), at_one("40", "41")).verdict == Compliance::hangs);
  CHECK(judge_gradation(report(), at_one("40", "41"), 0).verdict == Compliance::holds);
  CHECK(judge_gradation(report(), at_one("38", "39.5"), 2).verdict == Compliance::hangs);
}

TEST_CASE("a judged gradation has its sieves and its reports") {
  const JudgedGradation judged = judge_gradation(report(), at_one("30", "40.01"));
  CHECK(judged.id == "sand");
  REQUIRE(judged.sieves.size() == 1);
  CHECK(judged.sieves[0].passing->lower() == 40);
  CHECK(judged.sieves[0].least.lower() == ratio(3995, 100));
  CHECK(judged.sieves[0].most.upper() == ratio(4005, 100));
  CHECK(judged.sieves[0].verdict == Compliance::hangs);
  CHECK(judged.json.find("mdm-judge-1") != std::string::npos);
  CHECK(judged.text.find("HANGS") != std::string::npos);
}

TEST_CASE("below the finest sieve nothing is told of the curve itself") {
  const Specification fine =
      read_specification("size_mm,passing_min_percent,passing_max_percent\n0.1,0,5\n", "limits.csv");
  const JudgedGradation judged = judge_gradation(report(), fine);
  REQUIRE(judged.sieves.size() == 1);
  CHECK_FALSE(judged.sieves[0].passing);
  CHECK(judged.verdict == Compliance::hangs);
}

TEST_CASE("specifications come with the library, and broken ones are refused") {
  REQUIRE(shipped_specification("astm-c33-fine"));
  CHECK_FALSE(shipped_specification("astm-c33-fin"));
  CHECK_THROWS_AS(at_one("50", "40"), InputError);
}

} // namespace judge_test
