// Verdicts on hand-made gradations, on both sides of every bound.

#include "catch.hpp"
#include "crosscheck/other_answer.hpp"

#include <mdm/crosscheck/crosscheck.hpp>
#include <mdm/gradation/read_gradation.hpp>

namespace crosscheck_test {

using namespace mdm;

namespace {

Crosscheck problem(const std::string &sizes, const std::string &masses, const std::string &more = "") {
  return Crosscheck(read_json_gradation(
      R"({"id":"p","sizes":[)" + sizes + R"(],"masses":[)" + masses + "]" + more + "}", "test", "1"));
}

CrosscheckRow judge(const Crosscheck &p, const std::string &quantities, const std::string &sizes = "",
                    const Rational &tolerance = ratio(1, 1000000000), const std::string &unit = "mm") {
  return p.judge(json_answer(R"({"quantities":[)" + quantities + "]" +
                             (sizes.empty() ? "" : R"(,"sizes":[)" + sizes + "]") + R"(,"unit":")" + unit +
                             "\"}"),
                 tolerance);
}

void check_no_match(const CrosscheckRow &row, const std::string &part) {
  INFO(row.reason);
  CHECK(row.verdict == AnswerVerdict::not_a_match);
  CHECK(!row.ratio);
  CHECK(row.reason.find(part) != std::string::npos);
}

/// (1, 2] with 2 and (2, 3] with 1: q is a match iff max(q1 / 2, 8 q2) < min(4 q1, 27 q2); the least is 3, 1.
Crosscheck small() {
  return problem("1,2,3", "2,1,0");
}

/// (1, 2] with 3 * 1.5^3 and (2, 3] with 2.5^3: three of 1.5 and one of 2.5 match; two particles suffice.
Crosscheck exact() {
  return problem("1,2,3", "10.125,15.625,0");
}

} // namespace

TEST_CASE("quantities alone are minimal, larger, or no match at a bound", "[study]") {
  const CrosscheckRow least = judge(small(), "3,1");
  CHECK(least.id == "p");
  CHECK(least.verdict == AnswerVerdict::minimal);
  CHECK(least.particles == Integer(4));
  CHECK(least.minimum == Integer(4));
  CHECK(least.ratio == Rational(1));
  CHECK(!least.max_error);
  CHECK(least.reason.empty());
  const CrosscheckRow larger = judge(small(), "6,2");
  CHECK(larger.verdict == AnswerVerdict::larger);
  CHECK(larger.ratio == Rational(2));
  // 4 q1 = 8 q2: the larger class needs a scale above 8, the smaller one has up to 8.
  const CrosscheckRow tie = judge(small(), "2,1");
  check_no_match(tie,
                 "class 1 (1, 2] with 2 particles can hold its mass at scales up to 8, class 2 (2, 3] with "
                 "1 particle only above 8");
  CHECK(tie.particles == Integer(3));
  CHECK(tie.minimum == Integer(4));
  // q1 / 2 = 27 q2.
  CHECK(judge(small(), "53,1").verdict == AnswerVerdict::larger);
  check_no_match(judge(small(), "54,1"), "class 2 (2, 3] with 1 particle can hold");
}

TEST_CASE("a brute force over small vectors finds the same matches", "[study]") {
  const Crosscheck p = small();
  for (int q1 = 1; q1 <= 60; ++q1)
    for (int q2 = 1; q2 <= 4; ++q2) {
      // Scales in steps of 1/4: all ends are multiples of 1/2, so a window holds one of them.
      bool match = false;
      for (int s = 1; s <= 4 * 27 * 4; ++s)
        match = match || (2 * q1 < s && s <= 16 * q1 && 32 * q2 < s && s <= 108 * q2);
      const AnswerVerdict expected = !match         ? AnswerVerdict::not_a_match
                                     : q1 + q2 == 4 ? AnswerVerdict::minimal
                                                    : AnswerVerdict::larger;
      INFO(q1 << " " << q2);
      CHECK(judge(p, std::to_string(q1) + "," + std::to_string(q2)).verdict == expected);
    }
}

TEST_CASE("classes without mass may be left out or have 0", "[study]") {
  const Crosscheck p = problem("1,1.5,2,3", "1,0,1,0");
  CHECK(judge(p, "9,1").verdict == judge(p, "9,0,1").verdict);
  CHECK(judge(p, "9,0,1", "1.2,null,2.1").verdict == AnswerVerdict::not_a_match);
  check_no_match(judge(p, "9,1,1"), "class 2 (1.5, 2] has no mass but 1 particle");
  check_no_match(judge(p, "0,1"), "class 1 (1, 1.5] has mass but no particles");
  check_no_match(judge(p, "9"),
                 "there is 1 quantity: 2 with mass, or one for each of the 3 classes, is right");
  check_no_match(judge(p, "9,0,1,0"), "there are 4 quantities");
  check_no_match(judge(small(), "1,2,3"), "there are 3 quantities: one for each of the 2 classes is right");
  check_no_match(judge(p, "9,1", "1.2"), "there are 1 sizes for 2 quantities");
}

TEST_CASE("sizes are right within the tolerance of themselves", "[study]") {
  const CrosscheckRow row = judge(exact(), "3,1", "1.5,2.5", 0);
  CHECK(row.verdict == AnswerVerdict::larger);
  CHECK(row.minimum == Integer(2));
  CHECK(row.ratio == ratio(2, 1));
  CHECK(row.max_error == Rational(0));
  // Scales are free: all sizes may be larger by a factor.
  CHECK(judge(exact(), "3,1", "1.56,2.6", 0).verdict == AnswerVerdict::larger);
  check_no_match(judge(exact(), "3,1", "1.56,2.5", 0),
                 "the sizes do not fit the quantities: class 1 (1, 2] with 3 "
                 "particles has its mass at scales from");
  check_no_match(judge(exact(), "3,1", "1.5,2.50000001"), "the sizes do not fit");
  CHECK(judge(exact(), "3,1", "1.5,2.50000001", ratio(1, 100000000)).verdict == AnswerVerdict::larger);
  // x1 (1 + e) = 1.5 t and x2 (1 - e) = 2.5 t for one t: both of them off by e in opposite directions.
  CHECK(judge(exact(), "3,1", "1.35,2.75", ratio(1, 10)).verdict == AnswerVerdict::larger);
  check_no_match(judge(exact(), "3,1", "1.35,2.75", ratio(1, 11)), "the sizes do not fit");
}

TEST_CASE("sizes have units, and bounds instead of a value", "[study]") {
  CHECK(judge(exact(), "3,1", "1500,2500", 0, "um").verdict == AnswerVerdict::larger);
  CHECK(judge(exact(), "3,1", "0.0015,0.0025", 0, "m").verdict == AnswerVerdict::larger);
  CHECK(judge(problem("1000,2000,3000", "10.125,15.625,0", R"(,"unit":"um")"), "3,1", "1.5,2.5", 0).verdict ==
        AnswerVerdict::larger);
  CHECK(judge(exact(), "3,1", "[1.4,1.6],[2.4,2.6]", 0).verdict == AnswerVerdict::larger);
  CHECK(judge(exact(), "3,1", "[1.4,1.6],null", 0).verdict == AnswerVerdict::larger);
  check_no_match(judge(exact(), "3,1", "[1.4,1.45],[2.5,2.6]", 0), "the sizes do not fit");
  CHECK(judge(exact(), "3,1", "[1.4,1.5],[2.5,2.6]", 0).verdict == AnswerVerdict::larger);
}

TEST_CASE("a size outside its class is named, the lower sieve being outside", "[study]") {
  check_no_match(judge(exact(), "3,1", "1,2.5", 0), "the size 1 is outside its class 1 (1, 2]");
  check_no_match(judge(exact(), "3,1", "1.5,3.1", 0), "the size 3.1 is outside its class 2 (2, 3]");
  check_no_match(judge(exact(), "3,1", "-1,2.5"), "the size -1 is outside");
  check_no_match(judge(exact(), "3,1", "0,2.5"), "the size 0 is outside");
  // Both sizes on their upper sieve: 8 q1 / 8 = 27 q2 / 27.
  const Crosscheck upper = problem("1,2,3", "8,27,0");
  CHECK(judge(upper, "1,1", "2,3", 0).verdict == AnswerVerdict::minimal);
  // An ulp beyond the sieve is within the tolerance, but not without.
  CHECK(judge(upper, "1,1", "2.0000000000000004,3").verdict == AnswerVerdict::minimal);
  check_no_match(judge(upper, "1,1", "2.0000000000000004,3", 0), "outside");
}

TEST_CASE("the open end of one class excludes the only scale of another", "[study]") {
  // Class 1 needs s > 1; one of 2.5 has class 2's mass at s = 1.
  const Crosscheck p = problem("1,2,3", "1,15.625,0");
  check_no_match(judge(p, "1,1", "null,2.5", 0),
                 "has its mass at scales above 1, class 2 (2, 3] with 1 particle "
                 "only up to 1");
  CHECK(judge(p, "1,1", "null,2.5000001", 0).verdict == AnswerVerdict::minimal);
  // The closed end does not: class 1 needs s <= 8.
  const Crosscheck closed = problem("1,2,3", "8,15.625,0");
  CHECK(judge(closed, "1,1", "null,2.5", 0).verdict == AnswerVerdict::minimal);
}

TEST_CASE("factors weigh the classes", "[study]") {
  // With c = (2, 1) three of 1.5 weigh 20.25.
  const Crosscheck p = problem("1,2,3", "20.25,15.625,0", R"(,"factors":[2,1,1])");
  const CrosscheckRow row = judge(p, "3,1", "1.5,2.5", 0);
  CHECK(row.verdict == AnswerVerdict::larger);
  CHECK(row.max_error == Rational(0));
  CHECK(judge(exact(), "3,1", "1.5,2.5", 0).verdict == AnswerVerdict::larger);
  check_no_match(judge(problem("1,2,3", "20.25,15.625,0"), "3,1", "1.5,2.5", 0), "the sizes do not fit");
}

TEST_CASE("the error is that of the sizes as stated", "[study]") {
  // 3 * 1.5^3 = 10.125 and 2.5^3 = 15.625; one of 2.5 more: 31.25 of 41.375.
  const CrosscheckRow row = judge(exact(), "3,2", "1.5,2.5");
  CHECK(row.verdict == AnswerVerdict::not_a_match);
  CHECK(row.max_error == Rational(ratio(31250, 41375) - ratio(15625, 25750)));
  // A size on the lower sieve belongs to the class below: here to none.
  CHECK(judge(exact(), "3,1", "1,2.5").max_error == Rational(ratio(10125, 25750)));
  CHECK(!judge(exact(), "3,1").max_error);
  CHECK(!judge(exact(), "3,1", "1.5,null").max_error);
  CHECK(!judge(exact(), "3,1", "0,2.5").max_error);
}

TEST_CASE("failures keep their reasons beside the minimum", "[study]") {
  const CrosscheckRow row = small().judge(failed_answer("other", AnswerVerdict::crashed, "signal 11"), 0);
  CHECK(row.verdict == AnswerVerdict::crashed);
  CHECK(row.reason == "signal 11");
  CHECK(row.id == "p");
  CHECK(!row.particles);
  CHECK(row.minimum == Integer(4));
}

TEST_CASE("without a certain minimum a match is undecided unless it meets the bound", "[study]") {
  Limits limits;
  limits.max_steps = 0;
  const Gradation g = read_json_gradation(R"({"sizes":[1,2,3],"masses":[2,1,0]})", "test", "1");
  const Crosscheck p(g, limits); // knows 1, 1
  const CrosscheckRow row = judge(p, "3,1");
  CHECK(row.verdict == AnswerVerdict::undecided);
  CHECK(!row.minimum);
  CHECK(!row.ratio);
  CHECK(row.reason == "stopped at a limit: the smallest number is 2 or more");
  check_no_match(judge(p, "2,1"), "can hold");
  const Crosscheck easy(read_json_gradation(R"({"sizes":[1,2,3],"masses":[1,2,0]})", "test", "1"), limits);
  CHECK(judge(easy, "1,1").verdict == AnswerVerdict::minimal);
  CHECK(judge(easy, "1,1").minimum == Integer(2));
  CHECK(judge(easy, "2,1").verdict == AnswerVerdict::undecided);
}

TEST_CASE("an answer is judged from its JSON, and garbage is told") {
  const Crosscheck crosscheck(gradation_of({"1", "2", "3"}, {"2", "1", "0"}));
  const Integer least = *crosscheck.judge(R"({"quantities": ["1", "1"]})").minimum;
  CHECK(least > 2);
  CHECK(crosscheck.judge(R"({"quantities": ["1", "1"]})").verdict == AnswerVerdict::not_a_match);
  CHECK(crosscheck.judge(R"({"quantities": ["3", "1"]})").verdict == AnswerVerdict::minimal);
  CHECK(crosscheck.judge(R"({"quantities": ["6", "2"]})").verdict == AnswerVerdict::larger);
  CHECK(crosscheck.judge("none").verdict == AnswerVerdict::garbage);
}

TEST_CASE("classes that an answer names are those of the gradation", "[study]") {
  const auto with = [](const std::string &lower, const std::string &upper, const std::string &unit) {
    return small().judge(json_answer(R"({"unit":")" + unit + R"(","classes":[{"lower":")" + lower +
                                     R"(","upper":")" + upper +
                                     R"(","quantity":"3","size":null},{"quantity":"1","size":null}]})"),
                         0);
  };
  CHECK(with("1", "2", "mm").verdict == AnswerVerdict::minimal);
  CHECK(with("0.001", "0.002", "m").verdict == AnswerVerdict::minimal);
  check_no_match(with("1", "2.5", "mm"),
                 "class 1 of the answer is (1, 2.5], and that of the gradation (1, 2]");
  check_no_match(with("1", "2", "um"), "class 1 of the answer");
}

TEST_CASE("an answer that says another number than its quantities is not minimal", "[study]") {
  const auto with = [](const std::string &quantities, const std::string &particles) {
    return small().judge(
        json_answer(R"({"quantities":[)" + quantities + R"(],"particles":)" + particles + "}"), 0);
  };
  CHECK(with("3,1", "4").verdict == AnswerVerdict::minimal);
  check_no_match(with("3,1", "3"), "says that it has 3 particles, and its quantities are 4 together");
  const CrosscheckRow larger = with("6,2", "4");
  CHECK(larger.verdict == AnswerVerdict::larger);
  CHECK(larger.reason.find("says that it has 4 particles") != std::string::npos);
  check_no_match(with("1,1", "4"), "; the answer says that it has 4");
}

} // namespace crosscheck_test
