#include "../particles/support.hpp"
#include "answer/answer_sample.hpp"
#include "replaced.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

namespace answer_sample_test {

using namespace mdm;
using namespace mdm::test;
using mdm_test::replaced;

namespace {

Gradation gradation(std::vector<Rational> sizes, std::vector<Rational> masses,
                    std::vector<Rational> factors = {}, SizeUnit unit = SizeUnit::mm) {
  Gradation::Data d;
  d.unit = unit;
  d.sizes = std::move(sizes);
  d.masses = std::move(masses);
  d.factors = std::move(factors);
  return Gradation(std::move(d));
}

/// Two spheres, of sizes 2 and 16^(1/3).
const std::string two =
    R"({"schema":"mdm-answer-1","id":"g","status":"optimal","particles":"2","unit":"mm","classes":[)"
    R"({"lower":"0","upper":"1","mass":"0","quantity":"0","size":null},)"
    R"({"lower":"1","upper":"2","mass":"1","quantity":"1","size":["2","2"]},)"
    R"({"lower":"2","upper":"3","mass":"2","quantity":"1","size":["2.51","2.52"]}],)"
    R"("scale":{"above":"4","up_to":"8","chosen":"8"}})";

Gradation three_classes(SizeUnit unit = SizeUnit::mm, const Rational &factor = 1) {
  return gradation({0, 1 * factor, 2 * factor, 3 * factor}, {0, 1, 2, 0}, {}, unit);
}

AnswerDescription described(const std::string &answer, const Gradation &g = three_classes(),
                            const MassLaw &law = {}, const Rational &snap = 0) {
  return describe_answer(read_answer(answer, "a.json"), g, law, snap);
}

std::string refusal_of(const std::string &content) {
  try {
    read_answer(content, "a.json");
  } catch (const InputError &error) {
    CHECK(is_utf8(error.what()));
    return error.what();
  }
  FAIL("no InputError");
  return {};
}

bool is_exact_match(const AnswerDescription &d) {
  const MatchError e = d.description.error();
  return d.objections.empty() && d.description.articulately() == true && e.maximum.is_point() &&
         e.maximum.lo == 0;
}

} // namespace

TEST_CASE("answers: sizes that are roots match exactly") {
  const AnswerDescription d = described(two);
  CHECK(is_exact_match(d));
  CHECK(is_exact_match(described("\uFEFF" + two)));
  CHECK(d.description.of_class(1).first->is(2, 1)); // on its upper opening
  CHECK(d.description.of_class(2).first->is(16, 3));
  // At scale 8 the masses are 8 times those of the gradation.
  CHECK(d.description.error().as_given[2].lo == -14);
}

TEST_CASE("answers: in another unit than the gradation") {
  CHECK(is_exact_match(described(two, three_classes(SizeUnit::um, 1000))));
  CHECK(is_exact_match(described(two, three_classes(SizeUnit::m, ratio(1, 1000)))));
  CHECK_FALSE(described(two, three_classes(SizeUnit::um)).description.describes());
}

TEST_CASE("answers: what they claim is checked") {
  const auto objection = [](const std::string &part, const std::string &by) {
    const AnswerDescription d = described(replaced(two, part, by));
    REQUIRE(d.objections.size() == 1);
    return d.objections[0];
  };
  CHECK(contains(objection("\"2.51\",\"2.52\"", "\"2.52\",\"2.53\""), "the size in class 3 of the answer"));
  CHECK(contains(objection("\"2.51\",\"2.52\"", "\"2.5\",\"2.51\""), "the size in class 3 of the answer"));
  CHECK(contains(objection("\"chosen\":\"8\"", "\"chosen\":\"15/2\""), "class 2 and 1 more"));
  const AnswerDescription miscounted = described(replaced(two, "\"particles\":\"2\"", "\"particles\":\"3\""));
  CHECK(miscounted.objections.empty());
  CHECK(contains(miscounted.notes.at(0), "3 particles; its classes have 2"));
  CHECK(described(two, three_classes(), {2, 1}).objections.size() == 1);
}

TEST_CASE("answers: an upper opening is in the class, a lower one is not") {
  // Size 2 again, as the answer of a gradation with other sieves.
  CHECK(described(two, gradation({1, 2, 3}, {1, 2, 0})).description.of_class(0).count == 1);
  CHECK(described(two, gradation({1, ratio(19, 10), 3}, {1, 2, 0})).description.of_class(0).count == 0);
  CHECK(described(two, gradation({2, ratio(5, 2), 3}, {1, 2, 0})).description.below().count == 1);
  CHECK(described(two, gradation({1, 2, ratio(251, 100)}, {1, 2, 0})).description.above().count == 1);
  const AnswerDescription snapped =
      described(two, gradation({1, ratio(1999, 1000), 3}, {1, 2, 0}), {}, ratio(1, 1000));
  CHECK(snapped.description.of_class(0).count == 1);
  CHECK(snapped.description.snapped() == 1);
}

TEST_CASE("answers: factors are those of the class with the same bounds") {
  // c = 8 in the second class: 8 * 1^3, and 16 as before.
  const std::string dense =
      replaced(replaced(two, "\"lower\":\"1\"", "\"lower\":\"0.5\""), "\"2\",\"2\"", "\"1\",\"1\"");
  CHECK(is_exact_match(described(dense, gradation({0, ratio(1, 2), 2, 3}, {0, 1, 2, 0}, {1, 8, 1, 1}))));
  CHECK_THROWS_AS(described(two, gradation({0, ratio(1, 2), 2, 3}, {0, 1, 2, 0}, {1, 8, 1, 1})), InputError);
}

TEST_CASE("answers: irrational laws match exactly too") {
  // x^(1/2) with s^2 = 2: sqrt 2 in the second class, 2 sqrt 2 in the third.
  const std::string text =
      R"({"schema":"mdm-answer-1","id":"g","status":"feasible","particles":"2","unit":"mm","classes":[)"
      R"({"lower":"1","upper":"2","mass":"1","quantity":"1","size":["2","2"]},)"
      R"({"lower":"4","upper":"9","mass":"2","quantity":"1","size":["8","8"]}],)"
      R"("scale":{"chosen":"2","scale_power":"2"}})";
  CHECK(is_exact_match(described(text, gradation({1, 2, 4, 9}, {1, 0, 2, 0}), {1, 2})));
  CHECK_THROWS_AS(described(text), InputError);
}

TEST_CASE("answers: within a tolerance the achieved shares take the place of the masses") {
  // Size 2 and, instead of 16^(1/3), 2.5: masses 8 and 125/8.
  const std::string text =
      replaced(replaced(replaced(two, "\"chosen\":\"8\"}",
                                 "\"chosen\":\"189/8\"},\"achieved\":[\"0\",\"64/189\",\"125/189\"]"),
                        "\"2.51\"", "\"2.5\""),
               "\"2.52\"", "\"2.5\"");
  const AnswerDescription d = described(text);
  CHECK(d.objections.empty());
  CHECK(d.description.of_class(2).first->is(ratio(5, 2), 1));
  CHECK(d.description.error().shares[1].lo == ratio(64, 189));
  CHECK(contains(refusal_of(replaced(text, "[\"0\",", "[")), "achieved is not a string for each class"));
  CHECK(contains(refusal_of(replaced(text, "\"64/189\"", "\"0\"")),
                 "classes[1].achieved '0' is no fraction p/q above 0"));
}

TEST_CASE("answers: broken ones") {
  const auto broken = [](const std::string &part, const std::string &by) {
    return refusal_of(replaced(two, part, by));
  };
  CHECK(contains(refusal_of("{\n\"schema\": }"), "a.json:2: this is not JSON"));
  CHECK(contains(refusal_of("{}"), "a.json:1: schema is missing"));
  CHECK(contains(refusal_of("[]"), "a.json:1: this is neither the JSON answer"));
  CHECK(contains(refusal_of("\n{\"schema\":\"x\"}"), "a.json:2: schema 'x'"));
  CHECK(contains(broken("\"unit\":", "\n\"unit\":\"um\",\n\"unit\":"),
                 "a.json:3: key 'unit' is there twice: leave one"));
  CHECK(contains(broken("\"mass\":\"1\"", "\"mass\":\"1\",\"mass\":\"1\""),
                 "a.json:1: key 'mass' is there twice"));
  CHECK(contains(broken("mdm-answer-1", "mdm-batch-1"), "'mdm-batch-1' is not 'mdm-answer-1'"));
  CHECK(contains(broken("optimal", "none"), "status 'none' means that there is no sample"));
  CHECK(contains(broken("optimal", "unknown"), "status 'unknown' means that there is no sample"));
  CHECK(contains(broken("\"mm\"", "\"in\""), "unit 'in' is unknown"));
  CHECK(contains(broken("\"2\",\"unit\"", "true,\"unit\""), "particles is no number and no text"));
  CHECK(contains(broken("\"quantity\":\"1\"", "\"quantity\":\"-1\""),
                 "classes[1].quantity '-1' is not a whole"));
  CHECK(contains(broken("\"mass\":\"1\"", "\"mass\":\"x\""), "classes[1].mass 'x' is not a number"));
  CHECK(contains(broken("\"mass\":\"1\"", "\"mass\":\"0\""), "classes[1].mass is not above 0"));
  CHECK(contains(broken("[\"2\",\"2\"]", "null"), "classes[1].size is not [lo, hi]"));
  CHECK(contains(broken("[\"2\",\"2\"]", "[\"2\",\"1\"]"), "classes[1].size is not 0 <= lo <= hi"));
  CHECK(contains(broken("\"chosen\":\"8\"", "\"chosen\":\"8/0\""),
                 "scale.chosen '8/0' is no fraction p/q above 0"));
  CHECK(contains(broken("\"chosen\":\"8\"", "\"chosen\":\"-8\""),
                 "scale.chosen '-8' is no fraction p/q above 0"));
  CHECK(contains(broken("\"chosen\":\"8\"", "\"chosen\":\"8\",\"scale_power\":\"0\""), "scale_power"));
  CHECK(contains(broken("\"chosen\":\"8\"", "\"chosen\":\"-1/2\""), "scale.chosen '-1/2' is no fraction"));
  CHECK(contains(broken("\"scale\"", "\"scales\""), "scale is missing"));
  CHECK(contains(broken("\"id\":\"g\"", "\"id\":1e999"), "'1e999' is too large for a JSON number"));
  CHECK(contains(broken("\"id\":\"g\"", "\"id\":\"\xff\""), "this is not JSON"));
  CHECK(contains(broken("\"quantity\":\"1\"", "\"quantity\":\"" + std::string(100001, '1') + "\""),
                 "whole number"));
  CHECK(contains(broken("\"g\"", std::string(100000, '[')), "nested deeper"));
  for (std::size_t end = 1; end < two.size(); ++end)
    refusal_of(two.substr(0, end));
}

TEST_CASE("answers: sizes have as many digits as a narrow class takes, up to a limit") {
  const auto with_size = [](std::size_t zeros) {
    const std::string more(zeros, '0');
    return replaced(two, "\"2.51\",\"2.52\"", "\"2.51" + more + "\",\"2.52" + more + "\"");
  };
  const AnswerSample read = read_answer(with_size(5000), "a.json");
  CHECK(read.classes.at(1).size_lo == ratio(251, 100));
  CHECK(is_exact_match(described(with_size(5000))));
  CHECK(contains(refusal_of(with_size(100000)), "has more than 100000 digits: round it"));
  CHECK(contains(refusal_of(replaced(two, "\"2.51\"", "\"" + std::string(2000, '1') + "x\"")),
                 "is not a number"));
}

TEST_CASE("answers: whether a spread's bounds leave room for its mass is decided exactly") {
  // x^(1/2), two particles of the mass of size 4.5 each: sqrt 2 + sqrt 8 = 2 sqrt 4.5.
  const auto range = [](const std::string &lo, const std::string &hi) {
    return "[\"" + lo + "\",\"" + hi + "\"]";
  };
  const auto is_good = [](const std::string &lower, const std::string &first, const std::string &second) {
    const std::string text = fmt::format(
        R"({{"schema":"mdm-answer-1","id":"g","status":"feasible","particles":"2","unit":"mm","classes":[)"
        R"({{"lower":"{}","upper":"10","mass":"2","quantity":"2","size":["4.5","4.5"],"sizes":[{},{}]}}],)"
        R"("scale":{{"chosen":"9/2","scale_power":"2"}}}})",
        lower, first, second);
    const AnswerDescription d = described(text, gradation({parse_decimal(lower), 10}, {2, 0}), {1, 2});
    if (!d.objections.empty())
      CHECK(contains(d.objections.at(0), "its sizes do not have its mass together"));
    return d.objections.empty();
  };
  const std::string tiny = "." + std::string(59, '0') + "1", almost = "." + std::string(60, '9');
  CHECK(is_good("1", range("2", "3"), range("8", "9")));
  CHECK_FALSE(is_good("2", range("2", "3"), range("8", "9"))); // a size of 2 is below the class
  CHECK(is_good("2", range("2", "3"), range("7" + almost, "9")));
  CHECK_FALSE(is_good("1", range("2" + tiny, "3"), range("8", "9")));
  // Bounds from above may be reached.
  CHECK(is_good("1", range("1.5", "2"), range("7", "8")));
  CHECK(is_good("1", range("2", "2"), range("8", "8")));
  CHECK_FALSE(is_good("1", range("1.5", "2"), range("7", "7" + almost)));
  // sqrt 3 + sqrt(21 - 6 sqrt 6) = 2 sqrt 4.5 as well, of which no two are a fraction times each other.
  const std::string below = "6.303061543300931410816295551764651648204315116059979229403844",
                    above = "6.303061543300931410816295551764651648204315116059979229403845";
  CHECK(is_good("1", range("3", "4"), range(below, "9")));
  CHECK_FALSE(is_good("1", range("3", "4"), range(above, "9")));
  CHECK(is_good("1", range("2", "3"), range("5", above)));
  CHECK_FALSE(is_good("1", range("2", "3"), range("5", below)));
}

} // namespace answer_sample_test
