#include "catch.hpp"
#include "match/share_closure.hpp"
#include "plain_gradation.hpp"

#include <random>

namespace share_closure_test {

using namespace mdm;

namespace {

TolerantProblem problem_of(const Gradation &g, const Tolerance &tolerance) {
  return {g, {1, 1}, tolerance, {}};
}

/// Longest paths by the definition: over all pairs of sieves, with an edge for every bound.
class AllPaths {
public:
  explicit AllPaths(const TolerantProblem &problem) : k_(problem.classes()) {
    length_.assign((k_ + 1) * (k_ + 1), std::nullopt);
    const Tolerance &tolerance = problem.tolerance();
    for (std::size_t j = 0; j < k_; ++j) {
      raise(j, j + 1, 0);
      if (!tolerance.retained.empty()) {
        raise(j, j + 1, tolerance.retained[j].lo);
        raise(j + 1, j, -tolerance.retained[j].hi);
      }
      if (!tolerance.passing.empty()) {
        raise(0, j + 1, tolerance.passing[j].lo);
        raise(j + 1, 0, -tolerance.passing[j].hi);
      }
    }
    raise(0, k_, 1);
    raise(k_, 0, -1);
    const std::vector<Rational> passing = accumulated(problem.target());
    for (std::size_t a = 0; a <= k_ && tolerance.total; ++a)
      for (std::size_t b = 0; b <= k_; ++b)
        raise(a, b,
              Rational((b == 0 ? Rational(0) : passing[b - 1]) - (a == 0 ? Rational(0) : passing[a - 1]) -
                       *tolerance.total / 2));
    for (std::size_t c = 0; c <= k_; ++c)
      for (std::size_t a = 0; a <= k_; ++a)
        for (std::size_t b = 0; b <= k_; ++b)
          if (of(a, c) && of(c, b))
            raise(a, b, Rational(*of(a, c) + *of(c, b)));
  }

  const std::optional<Rational> &of(std::size_t a, std::size_t b) const { return length_[a * (k_ + 1) + b]; }
  bool contradicts() const {
    for (std::size_t a = 0; a <= k_; ++a)
      if (of(a, a) && *of(a, a) > 0)
        return true;
    return false;
  }

private:
  void raise(std::size_t a, std::size_t b, const Rational &w) {
    std::optional<Rational> &length = length_[a * (k_ + 1) + b];
    if (!length || *length < w)
      length = w;
  }

  std::size_t k_;
  std::vector<std::optional<Rational>> length_;
};

ShareBounds random_bounds(std::mt19937_64 &random, const Rational &middle) {
  if (random() % 3 == 0)
    return {0, 1};
  const Rational e = ratio(static_cast<int>(random() % 6), 20);
  return {std::max(Rational(0), Rational(middle - e)), std::min(Rational(1), Rational(middle + e))};
}

Tolerance random_tolerance(const Gradation &g, std::mt19937_64 &random) {
  Tolerance tolerance;
  const std::vector<Rational> target = shares(g), passing = accumulated(target);
  // Away from the gradation now and then, so that bounds contradict each other.
  const auto moved = [&](const Rational &share) {
    return Rational(share +
                    (random() % 4 == 0 ? ratio(static_cast<int>(random() % 5) - 2, 10) : Rational(0)));
  };
  if (random() % 2 == 0)
    for (std::size_t j = 0; j < g.classes(); ++j)
      tolerance.retained.push_back(random_bounds(random, moved(target[j])));
  if (random() % 2 == 0)
    for (std::size_t j = 0; j < g.classes(); ++j)
      tolerance.passing.push_back(random_bounds(random, moved(passing[j])));
  if (random() % 2 == 0)
    tolerance.total = ratio(static_cast<int>(random() % 9), 20);
  return tolerance;
}

} // namespace

TEST_CASE("bounds on shares of consecutive classes are the longest paths") {
  std::mt19937_64 random(71);
  int contradictory = 0, compared = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<Rational> sizes{0}, masses;
    const std::size_t k = 1 + random() % 6;
    for (std::size_t j = 0; j < k; ++j) {
      sizes.emplace_back(static_cast<int>(j) + 1);
      masses.emplace_back(static_cast<int>(j == 0 ? 1 : random() % 6));
    }
    masses.emplace_back(0);
    const Gradation g = gradation(sizes, masses);
    const TolerantProblem problem = problem_of(g, random_tolerance(g, random));
    const ShareClosure closure(problem);
    const AllPaths paths(problem);
    REQUIRE(closure.contradicts() == paths.contradicts());
    if (closure.contradicts()) {
      CHECK(closure.weight_of_contradiction() > 0);
      ++contradictory;
      continue;
    }
    for (std::size_t a = 0; a < k; ++a)
      for (std::size_t b = a; b < k; ++b) {
        CHECK(ratio(closure.lo(a, b), closure.unit()) == *paths.of(a, b + 1));
        CHECK(ratio(closure.hi(a, b), closure.unit()) == -*paths.of(b + 1, a));
        ++compared;
      }
  }
  CHECK(contradictory >= 300);
  CHECK(compared >= 10000);
}

TEST_CASE("bands narrow those before and behind them") {
  const Gradation g = gradation({0, 1, 2, 3, 4}, {1, 1, 1, 1, 0});
  const Tolerance band{{}, {{0, ratio(1, 10)}, {ratio(1, 2), 1}, {0, 1}, {0, 1}}, std::nullopt};
  const TolerantProblem problem = problem_of(g, band);
  const ShareClosure closure(problem);
  CHECK(ratio(closure.lo(0, 2), closure.unit()) == ratio(1, 2));
  CHECK(ratio(closure.lo(1, 1), closure.unit()) == ratio(2, 5));
  CHECK(ratio(closure.hi(2, 3), closure.unit()) == ratio(1, 2));
}

} // namespace share_closure_test
