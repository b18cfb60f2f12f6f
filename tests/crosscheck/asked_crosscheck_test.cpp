// Verdicts on answers to questions with a tolerance or other demands, on both sides of every bound.

#include "catch.hpp"
#include "crosscheck/other_answer.hpp"

#include <mdm/crosscheck/crosscheck.hpp>
#include <mdm/gradation/read_gradation.hpp>

#include <algorithm>
#include <random>

namespace asked_crosscheck_test {

using namespace mdm;

namespace {

/// (1, 2] with 2 and (2, 3] with 1.
Gradation sand() {
  return gradation_of({"1", "2", "3"}, {"2", "1", "0"}, SizeUnit::mm, "p");
}

Question within(const std::string &tolerance) {
  Question q;
  q.tolerances.push_back(parse_tolerance(tolerance));
  return q;
}

CrosscheckRow judged(const Gradation &g, const Question &question, const std::string &quantities,
                     const std::string &sizes = "") {
  return Crosscheck(g, question, {})
      .judge(json_answer(R"({"quantities":[)" + quantities + "]" +
                         (sizes.empty() ? "" : R"(,"sizes":[)" + sizes + "]") + "}"),
             0);
}

void check_no_match(const CrosscheckRow &row, const std::string &part) {
  INFO(row.reason);
  CHECK(row.verdict == AnswerVerdict::not_a_match);
  CHECK(row.reason.find(part) != std::string::npos);
}

} // namespace

TEST_CASE("quantities within a tolerance are minimal, larger or no match") {
  // 2 and 1 hold at most 16 and more than 8: a share of the first below 2/3 by as little as one likes.
  CHECK(judged(sand(), within("retained:0%"), "3,1").verdict == AnswerVerdict::minimal);
  check_no_match(judged(sand(), within("retained:0%"), "2,1"), "2 particles of class 1 are at most 2");
  const CrosscheckRow least = judged(sand(), within("retained:1%"), "2,1");
  CHECK(least.verdict == AnswerVerdict::minimal);
  CHECK(least.minimum == Integer(3));
  CHECK(judged(sand(), within("retained:1%"), "4,2").ratio == Rational(2));
  check_no_match(judged(sand(), within("retained:1%"), "1,1"), "class 1 holds at least");
  check_no_match(judged(sand(), within("retained:1%"), "1,2,3"), "there are 3 quantities");
}

TEST_CASE("stated sizes bind an answer within a tolerance") {
  // Shares of 2 particles of 2 and one of x: 16 / (16 + x^3) from 197/300 to 203/300.
  CHECK(judged(sand(), within("retained:1%"), "2,1", "2,2.01").verdict == AnswerVerdict::minimal);
  check_no_match(judged(sand(), within("retained:1%"), "2,1", "2,2.9"), "stated of class");
  check_no_match(judged(sand(), within("retained:1%"), "2,1", "2,3.1"),
                 "the size 3.1 is outside its class 2");
}

TEST_CASE("floors and least numbers are part of what is asked") {
  Question floors;
  floors.min_per_class = 2;
  check_no_match(judged(sand(), floors, "3,1"), "class 2 has 1 particle, and at least 2 are asked for");
  CHECK(judged(sand(), floors, "5,2").verdict == AnswerVerdict::minimal);
  CHECK(judged(sand(), floors, "6,2").verdict == AnswerVerdict::larger);
  Question many;
  many.at_least = 5;
  check_no_match(judged(sand(), many, "3,1"), "there are at least 5 particles");
}

TEST_CASE("an answer that there is no match is right where there is none") {
  const OtherAnswer none = json_answer(R"({"status":"infeasible"})"),
                    tired = json_answer(R"({"status":"gave up"})");
  CHECK(Crosscheck(sand(), within("retained:1%"), {}).judge(none, 0).verdict == AnswerVerdict::infeasible);
  CHECK(Crosscheck(sand(), within("retained:1%"), {}).judge(tired, 0).verdict == AnswerVerdict::gave_up);
  CHECK(Crosscheck(sand()).judge(none, 0).verdict == AnswerVerdict::infeasible);
}

namespace {

/// Whether masses exist for counts within errors e of the shares, by the mass M of all: between all points
/// where a bound of a class changes from one to the other, what the classes hold at least and at most is
/// linear in M.
bool has_masses(const std::vector<int> &q, const std::vector<Rational> &share, const Rational &e) {
  const auto cube = [](std::size_t x) { return Rational(static_cast<int>(x * x * x)); };
  const std::size_t k = q.size();
  const auto fits = [&](const Rational &M) {
    Rational least = 0, most = 0;
    bool is_open = false;
    for (std::size_t j = 0; j < k; ++j) {
      const Rational f = q[j] * cube(j + 1), F = q[j] * cube(j + 2);
      const Rational lo = std::max<Rational>(0, share[j] - e) * M,
                     hi = std::min<Rational>(1, share[j] + e) * M;
      if (lo > F || hi < f || (q[j] > 0 && hi <= f))
        return false;
      is_open |= q[j] > 0 && f >= lo;
      least += std::max(f, lo);
      most += std::min(F, hi);
    }
    return most >= M && (is_open ? least < M : least <= M);
  };
  std::vector<Rational> points;
  for (std::size_t j = 0; j < k; ++j)
    for (const Rational &mass : {Rational(q[j] * cube(j + 1)), Rational(q[j] * cube(j + 2))})
      for (const Rational &s : {Rational(share[j] - e), Rational(share[j] + e)})
        if (s > 0 && mass > 0)
          points.push_back(mass / s);
  std::sort(points.begin(), points.end());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (fits(points[i]))
      return true;
    if (i == 0)
      continue;
    // On the piece least and most are linear in M: 63 points between, and where either crosses M.
    const Rational width = points[i] - points[i - 1];
    const auto at = [&](const Rational &M) {
      Rational least = 0, most = 0;
      for (std::size_t j = 0; j < k; ++j) {
        least += std::max<Rational>(q[j] * cube(j + 1), (share[j] - e) * M);
        most += std::min<Rational>(q[j] * cube(j + 2), (share[j] + e) * M);
      }
      return std::pair<Rational, Rational>(least - M, most - M);
    };
    const auto [a, b] = at(points[i - 1]);
    const auto [c, d] = at(points[i]);
    std::vector<Rational> inner = {points[i - 1] + width / 2};
    for (const auto &[from, to] : {std::pair(a, c), std::pair(b, d)})
      if (from != to) {
        const Rational t = from / (from - to);
        for (const Rational &near :
             {Rational(t), Rational(t - ratio(1, 1000000)), Rational(t + ratio(1, 1000000))})
          if (near > 0 && near < 1)
            inner.push_back(points[i - 1] + near * width);
      }
    for (const Rational &M : inner)
      if (fits(M))
        return true;
  }
  return false;
}

} // namespace

TEST_CASE("random counts are a match exactly where masses exist, by another method") {
  std::mt19937 random(7);
  const auto draw = [&random](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most + 1));
  };
  unsigned matches = 0;
  for (unsigned run = 0; run < 400; ++run) {
    std::vector<std::string> masses;
    int all = 0;
    std::vector<int> m;
    for (int j = 0; j < 3; ++j)
      m.push_back(1 + draw(8));
    for (const int mass : m)
      all += mass;
    std::vector<Rational> share;
    for (const int mass : m) {
      masses.push_back(std::to_string(mass));
      share.push_back(ratio(mass, all));
    }
    masses.emplace_back("0");
    const Gradation g = gradation_of({"1", "2", "3", "4"}, masses);
    const std::vector<int> q = {draw(20), draw(6), draw(3)};
    if (q[0] + q[1] + q[2] == 0)
      continue;
    const int percent = 1 + draw(9);
    const CrosscheckRow row =
        judged(g, within("retained:" + std::to_string(percent) + "%"),
               std::to_string(q[0]) + "," + std::to_string(q[1]) + "," + std::to_string(q[2]));
    INFO(run << " " << q[0] << " " << q[1] << " " << q[2] << " of " << masses[0] << " " << masses[1] << " "
             << masses[2] << " within " << percent << " " << row.reason);
    const bool is_match = has_masses(q, share, ratio(percent, 100));
    CHECK((row.verdict != AnswerVerdict::not_a_match) == is_match);
    matches += is_match ? 1 : 0;
  }
  CHECK(matches > 20);
}

} // namespace asked_crosscheck_test
