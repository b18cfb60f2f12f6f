#include "catch.hpp"
#include "match/number_match.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <random>

namespace number_match_test {

using namespace mdm;

namespace {

using Kind = AskedTolerance::Kind;

/// Shares by number in small integers; deviations are compared in integers of one denominator.
struct SmallQuestion {
  std::vector<int> shares;
  std::vector<AskedTolerance> asked;

  Gradation gradation() const {
    std::vector<Rational> sizes, masses;
    for (std::size_t j = 0; j <= shares.size(); ++j) {
      sizes.emplace_back(static_cast<int>(j));
      masses.emplace_back(j < shares.size() ? shares[j] : 0);
    }
    return Gradation(sizes, masses);
  }
  int all() const {
    int sum = 0;
    for (const int s : shares)
      sum += s;
    return sum;
  }
  /// By the definition of each tolerance, all within whole percentages.
  bool holds(const std::vector<int> &quantities, int n) const {
    const int s = all();
    int passing = 0, total = 0, retained = 0, largest_passing = 0;
    for (std::size_t j = 0; j < shares.size(); ++j) {
      const int off = quantities[j] * s - shares[j] * n;
      passing += off;
      total += std::abs(off);
      retained = std::max(retained, std::abs(off));
      largest_passing = std::max(largest_passing, std::abs(passing));
    }
    if (asked.empty())
      return retained == 0;
    for (const AskedTolerance &a : asked) {
      const int off = a.kind == Kind::retained ? retained : a.kind == Kind::passing ? largest_passing : total;
      if (Rational(100 * off) > a.percent * n * s)
        return false;
    }
    return true;
  }
  /// Whether some quantities from class j on, `left` in all, complete those that are there.
  bool can_complete(std::vector<int> &quantities, std::size_t j, int left, int n) const {
    if (j + 1 == shares.size()) {
      quantities[j] = left;
      return holds(quantities, n);
    }
    for (quantities[j] = 0; quantities[j] <= left; ++quantities[j])
      if (can_complete(quantities, j + 1, left - quantities[j], n))
        return true;
    return false;
  }
  int least() const {
    std::vector<int> quantities(shares.size());
    for (int n = 1;; ++n)
      if (can_complete(quantities, 0, n, n))
        return n;
  }
};

SmallQuestion random_question(std::mt19937 &random) {
  const auto upto = [&random](unsigned most) { return static_cast<int>(random() % (most + 1)); };
  SmallQuestion q;
  q.shares.resize(static_cast<std::size_t>(1 + upto(3)));
  while (q.all() == 0)
    for (int &s : q.shares)
      s = upto(2) == 0 ? 0 : upto(6);
  // Shares of 1/20 to 1/4 tie with deviations often.
  const int percents[] = {0, 5, 10, 20, 25};
  const auto percent = [&] { return Rational(percents[upto(4)]); };
  switch (upto(4)) {
  case 0:
    break;
  case 1:
    q.asked = {{Kind::retained, percent()}};
    break;
  case 2:
    q.asked = {{Kind::passing, percent()}};
    break;
  case 3:
    q.asked = {{Kind::total, percent()}};
    break;
  default:
    q.asked = {{Kind::retained, percent()}, {Kind::passing, percent()}};
  }
  return q;
}

} // namespace

TEST_CASE("the smallest set by number is that of an enumeration", "[match]") {
  std::mt19937 random(7);
  for (int i = 0; i < 600; ++i) {
    const SmallQuestion q = random_question(random);
    const NumberMatch m = number_match(q.gradation(), q.asked);
    std::vector<int> quantities;
    for (const Integer &n : m.quantities)
      quantities.push_back(static_cast<int>(n));
    CAPTURE(i, q.shares, quantities);
    REQUIRE(m.is_smallest());
    REQUIRE(m.particles == q.least());
    REQUIRE(std::all_of(quantities.begin(), quantities.end(), [](int n) { return n >= 0; }));
    int sum = 0;
    for (const int n : quantities)
      sum += n;
    REQUIRE(m.particles == sum);
    REQUIRE(q.holds(quantities, sum));
  }
}

TEST_CASE("a search by number that ends early has the exact set and a bound", "[match]") {
  const Gradation g({0, 1, 2}, {parse_decimal("33.3333"), parse_decimal("66.6667"), 0});
  const NumberMatch m = number_match(g, {{Kind::retained, parse_decimal("0.00001")}}, 200);
  CHECK_FALSE(m.is_smallest());
  CHECK(m.lower_bound == 101);
  CHECK(m.particles == 1000000);
  CHECK(m.quantities == std::vector<Integer>{333333, 666667});
}

TEST_CASE("tolerances that shares by number do not have are refused", "[match]") {
  const Gradation g({0, 1, 2}, {1, 2, 0});
  CHECK_THROWS_AS(number_match(g, {{Kind::rounding, 0}}), InputError);
  CHECK_THROWS_AS(number_match(g, {{Kind::retained_file, 0}}), InputError);
  CHECK_THROWS_AS(number_match(g, {{Kind::total, 1}, {Kind::retained, 1}}), InputError);
}

} // namespace number_match_test
