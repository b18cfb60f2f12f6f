// What a caller is told while a search goes on, and that the caller can end it.

#include "catch.hpp"
#include "match/spectrum.hpp"
#include "plain_gradation.hpp"

#include <algorithm>

namespace progress_test {

using namespace mdm;

namespace {

using Clock = std::chrono::steady_clock;

/// Sieves so close that the sweep takes more steps than a search may have.
Gradation narrow_classes() {
  std::vector<Rational> sizes, masses;
  for (int j = 0; j <= 8; ++j) {
    sizes.push_back(1 + ratio(j, power_of_ten(11)));
    masses.emplace_back(j == 8 ? 0 : 11 + j * j % 7);
  }
  return gradation(std::move(sizes), std::move(masses));
}

/// So many classes that the first node of a search takes seconds.
Gradation many_classes() {
  std::vector<Rational> sizes{1}, masses;
  for (int j = 0; j < 150; ++j) {
    sizes.push_back(ratio(floor(Rational(sizes.back() * 10400)), 10000));
    masses.emplace_back(1 + j * 7 % 11);
  }
  masses.emplace_back(0);
  return gradation(std::move(sizes), std::move(masses));
}

/// Ends the search at the call with the number `last`, counted from 1, and keeps what it was told.
struct Caller {
  std::size_t last;
  std::vector<Progress> told = {};
  std::vector<Clock::time_point> at = {};

  ProgressCall call() {
    return [this](const Progress &known) {
      told.push_back(known);
      at.push_back(Clock::now());
      return told.size() < last;
    };
  }
};

/// What holds whenever a search was ended.
void check_stopped(const Match &m, const Caller &caller) {
  CHECK(caller.told.size() == caller.last); // not once more
  CHECK(m.status == Status::feasible);
  CHECK_FALSE(m.complete);
  CHECK(m.evidence().has_value() == m.proof.bound.has_value());
  CHECK((m.tolerance || m.proof.bound == m.lower_bound));
  REQUIRE(m.particles().has_value());
  CHECK(m.lower_bound <= *m.particles());
  for (std::size_t i = 0; i < caller.told.size(); ++i) {
    const Progress &known = caller.told[i];
    CHECK(known.lower_bound >= 1);
    CHECK(known.lower_bound <= *m.particles());
    if (known.particles)
      CHECK(m.lower_bound <= *known.particles);
    if (i > 0)
      CHECK(caller.at[i] - caller.at[i - 1] >= std::chrono::milliseconds(99));
  }
}

} // namespace

TEST_CASE("the caller of an exact search is told of it and can end it") {
  for (const std::size_t last : {1U, 3U}) {
    Caller caller{last};
    SolveOptions options;
    options.progress = caller.call();
    const Match m = solve(narrow_classes(), {}, options);
    check_stopped(m, caller);
    const auto is_under_way = [](const Progress &known) { return known.steps > 0; };
    CHECK((last == 1 || std::any_of(caller.told.begin(), caller.told.end(), is_under_way)));
    CHECK(caller.told.back().lower_bound <= m.lower_bound);
    CHECK(caller.told.back().particles.has_value());
  }
}

TEST_CASE("the caller of a search for many particles is told bounds of these") {
  Question question;
  question.at_least = power_of_ten(40);
  Caller caller{1};
  SolveOptions options;
  options.progress = caller.call();
  Gradation g = narrow_classes();
  const Match m = solve(std::move(g), question, options);
  REQUIRE(caller.told.size() == 1);
  CHECK(caller.told[0].lower_bound >= question.at_least);
  CHECK(m.lower_bound >= question.at_least);
  CHECK(*m.particles() >= m.lower_bound);
}

TEST_CASE("the caller of a search within a tolerance is told of it and can end it") {
  Question question;
  question.tolerances = {parse_tolerance("total:1%")};
  for (const std::size_t last : {1U, 2U}) {
    Caller caller{last};
    SolveOptions options;
    options.progress = caller.call();
    const Match m = solve(many_classes(), question, options);
    check_stopped(m, caller);
    REQUIRE(m.tolerance.has_value());
  }
}

TEST_CASE("the caller of a spectrum can end it") {
  SolveOptions options;
  options.limits.max_steps = 1000;
  const Match m = solve(narrow_classes(), {}, options);
  Caller caller{1};
  const Spectrum s = spectrum(m, {}, caller.call());
  CHECK(caller.told.size() == 1);
  CHECK_FALSE(s.complete);
}

TEST_CASE("a search that is not ended has the same answer as without a caller") {
  Question question;
  for (const bool is_tolerant : {false, true}) {
    if (is_tolerant)
      question.tolerances = {parse_tolerance("retained:1%")};
    const Gradation g = gradation({1, 2, 3, 5, 8}, {3, 2, 7, 5, 0});
    SolveOptions options;
    options.progress = [](const Progress &) { return true; };
    const Match m = solve(g, question, options), same = solve(g, question);
    CHECK(m.status == Status::optimal);
    CHECK(m.sample->quantities == same.sample->quantities);
    CHECK(m.evidence().has_value());
  }
}

} // namespace progress_test
