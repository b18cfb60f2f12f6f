#include "catch.hpp"
#include "match/brute_force.hpp"
#include "match/budget.hpp"
#include "plain_gradation.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace budget_test {

using namespace mdm;

namespace {

using Kind = AskedTolerance::Kind;

/// The smallest match at a tolerance; nothing where there is none.
std::optional<Integer> particles_at(const Gradation &g, Question question, Kind kind,
                                    const Rational &percent) {
  question.tolerances = {{kind, percent}};
  const Match m = solve(g, question);
  REQUIRE(m.complete);
  return m.particles();
}

bool suffices(const Gradation &g, const Question &question, const Budget &budget, const Rational &percent) {
  const std::optional<Integer> n = particles_at(g, question, budget.kind, percent);
  return n && *n <= budget.particles;
}

} // namespace

TEST_CASE("the tolerance of a budget is the first on the grid that suffices") {
  std::mt19937_64 random(81);
  const Kind kinds[] = {Kind::retained, Kind::passing, Kind::total};
  const Rational grids[] = {7, ratio(5, 2), 10, 30};
  int none = 0, exact = 0, between = 0;
  for (int i = 0; i < 200; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Budget budget{1 + static_cast<int>(random() % 9), BudgetBy::tolerance, kinds[random() % 3],
                        grids[random() % 4]};
    Question question;
    if (random() % 3 == 0)
      question.min_per_class = static_cast<int>(1 + random() % 3);
    const BudgetMatch found = solve_within_budget(g, question, budget);
    const MatchBudget &known = found.match.budget.value();
    CHECK(known.is_decided);
    const Rational widest = budget.kind == Kind::total ? 200 : 100;
    std::optional<Rational> first, before;
    for (Rational percent = 0;; percent += budget.grid) {
      const Rational cut = std::min(percent, widest);
      if (suffices(g, question, budget, cut)) {
        first = cut;
        break;
      }
      before = cut;
      if (cut == widest)
        break;
    }
    CHECK(known.enough == first);
    CHECK(known.next_finer == before);
    if (!first) {
      CHECK(found.match.status == Status::none);
      CHECK_FALSE(found.finer.has_value());
      ++none;
      continue;
    }
    CHECK(found.match.status == Status::optimal);
    CHECK(*found.match.particles() <= budget.particles);
    CHECK(found.finer.has_value() == before.has_value());
    if (found.finer) {
      CHECK(found.finer->status == Status::none);
      CHECK((found.finer->complete || *found.finer->proof.bound > budget.particles));
    }
    ++(before ? between : exact);
  }
  CHECK(none >= 5);
  CHECK(exact >= 5);
  CHECK(between >= 50);
}

TEST_CASE("a sum of deviations may need more than 100 points") {
  const Gradation g = gradation_of({"1", "4", "5.5", "7.5", "9.5"}, {"1000000", "18", "19", "3", "0"});
  Question question;
  question.min_per_class = 1;
  question.law = {2, 1};
  const BudgetMatch found = solve_within_budget(g, question, {4, BudgetBy::tolerance, Kind::total});
  const MatchBudget &known = found.match.budget.value();
  REQUIRE(known.enough.has_value());
  CHECK(*known.enough > 100);
  CHECK(*known.enough < 200);
  CHECK(known.is_decided);
  CHECK(*found.match.particles() == 4);
  CHECK(solve_within_budget(g, question, {3, BudgetBy::tolerance, Kind::total}).match.status == Status::none);
}

TEST_CASE("the step from 10 to 10.001 percentage points can be the one that matters") {
  // (1, 2], (2, 3], 20 and 80 %: at 10 in sum one particle each would touch the bounds.
  Question question;
  question.law = {1, 1};
  const BudgetMatch found =
      solve_within_budget(gradation({1, 2, 3}, {2, 8, 0}), question, {2, BudgetBy::tolerance, Kind::total});
  CHECK(found.match.budget->enough == Rational(10) + ratio(1, 1000));
  CHECK(found.match.budget->next_finer == Rational(10));
}

TEST_CASE("where a limit leaves it open, a budget has no tolerance or a bracket") {
  const Gradation g = gradation({0, 2, 5, 9}, {2, 1, 1, 0});
  SolveOptions options;
  options.limits.deadline = std::chrono::steady_clock::now();
  const BudgetMatch found = solve_within_budget(g, {}, {3, BudgetBy::tolerance, Kind::retained}, options);
  const MatchBudget &known = found.match.budget.value();
  if (known.enough && *known.enough > 0)
    CHECK((!known.is_decided || *known.enough - *known.next_finer == ratio(1, 1000)));
}

TEST_CASE("whatever ends a search early, the match of a budget has no more particles, and its step is told") {
  std::mt19937_64 random(83);
  int open = 0, decided = 0;
  for (int i = 0; i < 200; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Budget budget{2 + static_cast<int>(random() % 9), BudgetBy::tolerance, Kind::retained,
                        ratio(1, 100)};
    SolveOptions options;
    if (i % 2 == 0)
      options.limits.node_limit = random() % 4;
    int calls = static_cast<int>(random() % 4);
    if (i % 3 == 0)
      options.progress = [&calls](const Progress &) { return calls-- > 0; };
    if (i % 5 == 0)
      options.limits.deadline = std::chrono::steady_clock::now();
    const BudgetMatch found = solve_within_budget(g, {}, budget, options);
    const MatchBudget &known = found.match.budget.value();
    CHECK(found.match.has_answer() == known.enough.has_value());
    if (found.match.has_answer()) {
      CHECK(*found.match.particles() <= budget.particles);
      CHECK(found.match.lower_bound <= *found.match.particles());
      CHECK(found.match.question.tolerances.front().percent == *known.enough);
    }
    CHECK(found.finer.has_value() == (known.enough && known.next_finer));
    ++(known.is_decided ? decided : open);
  }
  CHECK(open >= 20);
  CHECK(decided >= 20);
}

TEST_CASE("a gap is of the match at the step, and changes no step") {
  std::mt19937_64 random(84);
  for (int i = 0; i < 60; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Budget budget{2 + static_cast<int>(random() % 9), BudgetBy::tolerance, Kind::passing, 1};
    SolveOptions options;
    options.limits.gap = 10;
    const MatchBudget with_gap = solve_within_budget(g, {}, budget, options).match.budget.value();
    const MatchBudget without = solve_within_budget(g, {}, budget).match.budget.value();
    CHECK(with_gap.enough == without.enough);
    CHECK(with_gap.next_finer == without.next_finer);
    CHECK(with_gap.is_decided);
  }
}

TEST_CASE("that no size factor suffices is shown of matches of any volume") {
  const Gradation g = gradation({1, 2, 3}, {7, 3, 0});
  Question question;
  question.solids = SolidsVolume{Rational(1000)};
  const BudgetMatch found = solve_within_budget(g, question, {1, BudgetBy::size_factor});
  CHECK(found.match.status == Status::none);
  CHECK(found.match.budget->is_decided);
  CHECK_FALSE(found.match.question.solids.has_value());
  CHECK(found.match.lower_bound > 1);
}

TEST_CASE("the size factor of a budget is the first on the grid with which a specimen needs no more") {
  std::mt19937_64 random(82);
  const Rational grids[] = {ratio(1, 2), ratio(1, 3), ratio(1, 20)};
  int none = 0, whole = 0, between = 0;
  for (int i = 0; i < 100; ++i) {
    const Gradation g = brute::random_gradation(random);
    const Budget budget{3 + static_cast<int>(random() % 60), BudgetBy::size_factor, Kind::retained,
                        grids[random() % 3]};
    Question question;
    question.solids = SolidsVolume{Rational(50 + static_cast<int>(random() % 20000))};
    if (random() % 3 == 0)
      question.tolerances = {{Kind::retained, Rational(2)}};
    const BudgetMatch found = solve_within_budget(g, question, budget);
    const MatchBudget &known = found.match.budget.value();
    CHECK(known.is_decided);
    Question anywhere = question;
    anywhere.solids.reset();
    const Match free = solve(g, anywhere);
    if (*free.particles() > budget.particles) {
      CHECK_FALSE(known.enough.has_value());
      CHECK(found.match.status == Status::none);
      ++none;
      continue;
    }
    const auto particles_with = [&](const Rational &factor) {
      Question asked = question;
      asked.size_factor = factor;
      const Match m = solve(g, asked);
      REQUIRE(m.complete);
      return *m.particles();
    };
    Rational first = 1;
    while (particles_with(first) > budget.particles)
      first += budget.grid;
    CHECK(known.enough == first);
    CHECK(found.match.question.size_factor == first);
    CHECK(*found.match.particles() == particles_with(first));
    CHECK(known.next_finer == (first > 1 ? std::optional<Rational>(first - budget.grid) : std::nullopt));
    CHECK(found.finer.has_value() == (first > 1));
    ++(first > 1 ? between : whole);
  }
  CHECK(none >= 5);
  CHECK(whole >= 5);
  CHECK(between >= 30);
}

TEST_CASE("where a limit leaves a size factor open, nothing is said to suffice for none") {
  Question question;
  question.solids = SolidsVolume{Rational(1000000)};
  SolveOptions options;
  options.limits.deadline = std::chrono::steady_clock::now();
  question.tolerances = {{Kind::retained, Rational(1)}};
  const BudgetMatch found = solve_within_budget(gradation({0, 2, 5, 9}, {2, 1, 1, 0}), question,
                                                {3, BudgetBy::size_factor}, options);
  const MatchBudget &known = found.match.budget.value();
  CHECK((known.enough || !known.is_decided || found.match.status == Status::none));
}

} // namespace budget_test
