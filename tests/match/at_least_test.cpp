#include "brute_force.hpp"
#include "catch.hpp"
#include "match/at_least.hpp"
#include "match/problem_spectrum.hpp"

namespace at_least_test {

using namespace mdm;

namespace {

bool is_match(const Problem &p, const std::vector<Integer> &q) {
  return p.lowest_scale(q) < p.highest_scale(q);
}

} // namespace

TEST_CASE("the smallest match with at least n particles is that of enumeration") {
  std::mt19937_64 random(10);
  for (int i = 0; i < 300; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Integer floor = static_cast<int>(1 + random() % 2);
    const std::set<Integer> reachable = brute::reachable(brute::problem(g, floor), 40);
    const Problem p(g, {}, floor);
    for (int n = 1; n <= 40; ++n) {
      const auto expected = reachable.lower_bound(n);
      if (expected == reachable.end())
        break;
      const AtLeastMatch found = at_least_match(p, n, 0);
      CHECK(total(found.q) == *expected);
      CHECK(is_match(p, found.q));
      for (std::size_t j = 0; j < found.q.size(); ++j)
        CHECK(found.q[j] >= p.classes()[j].floor);
      if (found.above > 0) {
        Integer most = 0;
        for (const std::optional<Integer> &h : largest_counts(p, found.above, false))
          most += h.value();
        CHECK(most < n);
      }
    }
  }
}

TEST_CASE("the crowded scale is the n-th smallest lower end") {
  std::mt19937_64 random(11);
  for (int i = 0; i < 300; ++i) {
    const Problem p(brute::random_gradation(random), {}, 1);
    std::vector<Rational> ends;
    bool pan = false;
    for (const ProblemClass &c : p.classes()) {
      pan = pan || c.f == 0;
      for (int q = 1; q <= 60; ++q)
        ends.push_back(ratio(q * c.f, c.mass));
    }
    std::sort(ends.begin(), ends.end());
    for (std::size_t n = 1; n <= 60; n += 7)
      CHECK(crowded_scale(p, n) == (pan ? Rational(0) : ends[n - 1]));
  }
}

TEST_CASE("a large n costs no more") {
  Gradation::Data data;
  data.sizes = {1, 2, 3, 5};
  data.masses = {3, 2, 7, 0};
  const Problem p(Gradation(data), {}, 1);
  const Integer n = power_of_ten(200) + 12345;
  CHECK(total(at_least_match(p, n, 0).q) == n);
}

TEST_CASE("the spectrum is that of enumeration") {
  std::mt19937_64 random(12);
  const Integer limit = 60;
  int gaps = 0;
  for (int i = 0; i < 300; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Integer floor = static_cast<int>(1 + random() % 3);
    const std::set<Integer> reachable = brute::reachable(brute::problem(g, floor), limit);
    const Spectrum s = spectrum(Problem(g, {}, floor));
    REQUIRE(s.complete);
    gaps += s.intervals.empty() ? 0 : 1;
    for (Integer n = 1; n <= limit; ++n) {
      bool found = n >= s.all_from;
      for (const auto &[from, to] : s.intervals)
        found = found || (from <= n && n <= to);
      CHECK(found == (reachable.count(n) == 1));
    }
  }
  CHECK(gaps >= 10);
}

TEST_CASE("a limited spectrum says from where on it is open") {
  Gradation::Data data;
  data.sizes = {10, 11, 20, 21};
  data.masses = {1, 0, 1, 0};
  const Problem p(Gradation(data), {}, 1);
  const Spectrum all = spectrum(p);
  const Spectrum part = spectrum(p, {1, std::nullopt});
  CHECK(all.complete);
  REQUIRE(all.intervals.size() > 1);
  CHECK_FALSE(part.complete);
  REQUIRE(part.intervals.size() == 1);
  CHECK(part.intervals[0].first == all.intervals[0].first);
  CHECK(part.all_from == part.intervals[0].second + 1);
}

TEST_CASE("the steps of a spectrum are not those of its sweeps") {
  Gradation::Data data;
  data.sizes = {100, 104, 108, 109, 112, 116};
  data.masses = {4, 5, 7, 5, 9, 0};
  const Problem p(Gradation(data), {}, 1);
  CHECK(least_match(p).chain.size() > 3);
  CHECK(spectrum(p, {3, std::nullopt}).intervals.size() >= 1);
}

} // namespace at_least_test
