#include "catch.hpp"
#include "match/simplex.hpp"

#include <algorithm>
#include <random>

namespace simplex_test {

using namespace mdm;

namespace {

/// sum coefficient_i x_i >= constant, or > if strict.
struct Inequality {
  std::vector<Rational> coefficients;
  Rational constant;
  bool strict;
};

/// Fourier-Motzkin elimination: some x satisfies all.
bool has_solution(std::vector<Inequality> all, std::size_t variables) {
  for (std::size_t x = 0; x < variables; ++x) {
    std::vector<Inequality> left, from_below, from_above;
    for (Inequality &i : all)
      (i.coefficients[x] == 0 ? left : i.coefficients[x] > 0 ? from_below : from_above).push_back(i);
    for (const Inequality &low : from_below)
      for (const Inequality &high : from_above) {
        const Rational a = -high.coefficients[x], b = low.coefficients[x];
        Inequality sum{{}, a * low.constant + b * high.constant, low.strict || high.strict};
        for (std::size_t i = 0; i < variables; ++i)
          sum.coefficients.push_back(a * low.coefficients[i] + b * high.coefficients[i]);
        left.push_back(std::move(sum));
      }
    all = std::move(left);
  }
  return std::all_of(all.begin(), all.end(),
                     [](const Inequality &i) { return i.strict ? i.constant < 0 : i.constant <= 0; });
}

/// Forms over a few variables with bounds, held twice: by the program, and as inequalities.
class Twins {
public:
  Twins(std::size_t variables, std::size_t forms, std::mt19937_64 &random)
      : variables_(variables), program(variables) {
    for (std::size_t v = 0; v < variables; ++v) {
      coefficients_.emplace_back(variables, Rational(0));
      coefficients_.back()[v] = 1;
    }
    for (std::size_t f = 0; f < forms; ++f) {
      coefficients_.emplace_back(variables, Rational(0));
      std::vector<std::pair<std::size_t, Rational>> terms;
      for (std::size_t v = 0; v < variables; ++v)
        if (random() % 4 != 0) {
          coefficients_.back()[v] =
              ratio(static_cast<int>(random() % 9) - 4, static_cast<int>(1 + random() % 3));
          terms.emplace_back(v, coefficients_.back()[v]);
        }
      program.add_form(terms);
    }
  }

  std::size_t size() const { return coefficients_.size(); }

  std::vector<Inequality> inequalities() const {
    std::vector<Inequality> all;
    for (std::size_t v = 0; v < size(); ++v) {
      if (const auto &low = program.lower(v))
        all.push_back({coefficients_[v], low->value, low->tiny > 0});
      if (const auto &high = program.upper(v)) {
        all.push_back({coefficients_[v], -high->value, high->tiny < 0});
        for (Rational &c : all.back().coefficients)
          c = -c;
      }
    }
    return all;
  }

  bool is_solution(const std::vector<Rational> &x) const {
    for (const Inequality &i : inequalities()) {
      Rational sum = 0;
      for (std::size_t v = 0; v < variables_; ++v)
        sum += i.coefficients[v] * x[v];
      if (i.strict ? sum <= i.constant : sum < i.constant)
        return false;
    }
    return true;
  }

  /// The multiples of bounds in the conflict add up to 0 >= something positive, or 0 > 0.
  bool is_contradiction() const {
    std::vector<Rational> left(variables_, Rational(0));
    Rational right = 0;
    bool strict = false;
    for (const Simplex::Term &term : program.conflict()) {
      const auto &bound = term.is_upper ? program.upper(term.variable) : program.lower(term.variable);
      if (!bound || term.multiplier <= 0)
        return false;
      const Rational by = term.is_upper ? Rational(-term.multiplier) : term.multiplier;
      for (std::size_t v = 0; v < variables_; ++v)
        left[v] += by * coefficients_[term.variable][v];
      right += by * bound->value;
      strict = strict || bound->tiny != 0;
    }
    return std::all_of(left.begin(), left.end(), [](const Rational &c) { return c == 0; }) &&
           (strict ? right >= 0 : right > 0);
  }

  /// No solution has a value of the variable below its value in the program.
  bool is_least(std::size_t variable) const {
    std::vector<Inequality> all = inequalities();
    const Infinitesimal &value = program.value(variable);
    Inequality less{coefficients_[variable], -value.value, !(value.tiny > 0)};
    for (Rational &c : less.coefficients)
      c = -c;
    all.push_back(std::move(less));
    return !has_solution(std::move(all), variables_);
  }

private:
  std::size_t variables_;
  std::vector<std::vector<Rational>> coefficients_;

public:
  Simplex program;
};

Simplex::Bound at_least(const Rational &r) {
  return Infinitesimal{r, 0};
}
Simplex::Bound above(const Rational &r) {
  return Infinitesimal{r, 1};
}
Simplex::Bound below(const Rational &r) {
  return Infinitesimal{r, -1};
}

Simplex::Bound random_bound(std::mt19937_64 &random, int tiny) {
  return Infinitesimal{ratio(static_cast<int>(random() % 13) - 6, static_cast<int>(1 + random() % 2)),
                       random() % 3 == 0 ? tiny : 0};
}

} // namespace

TEST_CASE("programs have values or a contradiction as elimination says, however bounds change") {
  std::mt19937_64 random(31);
  int solved = 0, refuted = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t variables = 1 + random() % 3;
    Twins twins(variables, random() % 4, random);
    for (int change = 0; change < 12; ++change) {
      const std::size_t v = random() % twins.size();
      if (random() % 2 == 0)
        twins.program.set_lower(v, random() % 4 == 0 ? std::nullopt : random_bound(random, 1));
      else
        twins.program.set_upper(v, random() % 4 == 0 ? std::nullopt : random_bound(random, -1));
      const std::size_t aim = random() % twins.size();
      const bool found = twins.program.find(aim);
      REQUIRE(found == has_solution(twins.inequalities(), variables));
      (found ? solved : refuted) += 1;
      if (!found) {
        REQUIRE(twins.is_contradiction());
        continue;
      }
      REQUIRE(twins.is_solution(twins.program.concrete_values(0, variables)));
      if (!twins.program.lower(aim))
        continue;
      twins.program.minimise(aim);
      REQUIRE(twins.is_solution(twins.program.concrete_values(0, variables)));
      REQUIRE(twins.is_least(aim));
    }
  }
  CHECK(solved >= 2000);
  CHECK(refuted >= 1300);
}

TEST_CASE("strict bounds exclude their ends") {
  Simplex program(1);
  program.set_lower(0, above(0));
  program.set_upper(0, at_least(0));
  CHECK_FALSE(program.find(0));
  CHECK(program.conflict().size() == 2);
  program.set_upper(0, below(1));
  CHECK(program.find(0));
  const Rational x = program.concrete_values(0, 1).front();
  CHECK((0 < x && x < 1));
  program.set_lower(0, at_least(1));
  CHECK_FALSE(program.find(0));
  program.set_upper(0, at_least(1));
  CHECK(program.find(0));
  CHECK(program.concrete_values(0, 1).front() == 1);
}

TEST_CASE("a strict bound on a sum excludes the only corner") {
  // x <= 1, y <= 1, x + y >= 2, and then x - y > 0.
  Simplex program(2);
  const std::size_t sum = program.add_form({{0, 1}, {1, 1}});
  const std::size_t difference = program.add_form({{0, 1}, {1, -1}});
  program.set_upper(0, at_least(1));
  program.set_upper(1, at_least(1));
  program.set_lower(sum, at_least(2));
  CHECK(program.find(0));
  program.set_lower(difference, above(0));
  CHECK_FALSE(program.find(0));
  program.set_lower(difference, at_least(0));
  CHECK(program.find(0));
}

TEST_CASE("bounds that contradict each other are forgotten when one of them is lifted") {
  Simplex program(1);
  program.set_lower(0, at_least(5));
  program.set_upper(0, at_least(3));
  CHECK_FALSE(program.find(0));
  program.set_upper(0, std::nullopt);
  CHECK(program.find(0));
  CHECK(program.value(0).value >= 5);
}

TEST_CASE("a program that cycles without care ends") {
  // Beale's example: least x5 = -3/4 x1 + 150 x2 - 1/50 x3 + 6 x4 is -1/20.
  Simplex program(4);
  const std::size_t a = program.add_form({{0, ratio(1, 4)}, {1, -60}, {2, ratio(-1, 25)}, {3, 9}});
  const std::size_t b = program.add_form({{0, ratio(1, 2)}, {1, -90}, {2, ratio(-1, 50)}, {3, 3}});
  const std::size_t goal = program.add_form({{0, ratio(-3, 4)}, {1, 150}, {2, ratio(-1, 50)}, {3, 6}});
  for (std::size_t x = 0; x < 4; ++x)
    program.set_lower(x, at_least(0));
  program.set_upper(a, at_least(0));
  program.set_upper(b, at_least(0));
  program.set_upper(2, at_least(1));
  program.set_lower(goal, at_least(-100));
  REQUIRE(program.find(goal));
  program.minimise(goal);
  CHECK(program.value(goal).value == ratio(-1, 20));
}

TEST_CASE("a deadline interrupts a program") {
  Simplex program(1, Watch(std::chrono::steady_clock::now() - std::chrono::seconds(1)));
  CHECK_THROWS_AS(program.add_form({{0, 2}}), Simplex::Interrupted);
}

} // namespace simplex_test
