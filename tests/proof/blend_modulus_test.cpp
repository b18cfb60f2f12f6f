// Blends with limits of a fineness modulus, against enumeration, and their proofs.

#include "blend/blend_certificate.hpp"
#include "catch.hpp"

#include <mdm/checker.hpp>
#include <mdm/gradation/read_gradation.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <algorithm>
#include <functional>
#include <random>

namespace blend_modulus_test {

using namespace mdm;

namespace {

/// Openings in mm and percents passing, ascending; nothing passes the first.
struct Stock {
  std::vector<Rational> sizes, passing;

  std::string file() const {
    std::string text = "size_mm,passing_percent\n";
    for (std::size_t i = sizes.size(); i-- > 0;)
      text += to_decimal(sizes[i]) + "," + to_decimal(passing[i]) + "\n";
    return text;
  }
  /// Linear in size.
  Rational at(const Rational &size) const {
    if (size <= sizes.front())
      return 0;
    for (std::size_t i = 1; i < sizes.size(); ++i)
      if (size <= sizes[i])
        return passing[i - 1] +
               (size - sizes[i - 1]) / (sizes[i] - sizes[i - 1]) * (passing[i] - passing[i - 1]);
    return 100;
  }
  /// What is retained on and above the sieves of EN 12620.
  Rational modulus() const {
    Rational sum = 0;
    for (const Rational &size :
         {ratio(1, 8), ratio(1, 4), ratio(1, 2), Rational(1), Rational(2), Rational(4)})
      sum += 1 - at(size) / 100;
    return sum;
  }
};

struct Case {
  std::vector<Stock> stocks;
  std::vector<Rational> costs;
  Rational least, most;  ///< of the modulus
  Rational passing_most; ///< at 1 mm
  int steps;

  std::string limits() const {
    return "size_mm,passing_min_percent,passing_max_percent\n8,100,100\n1,0," + to_decimal(passing_most) +
           "\n";
  }
};

Case random_case(std::mt19937 &random) {
  const auto upto = [&random](int most) {
    return static_cast<int>(random() % static_cast<unsigned>(most + 1));
  };
  Case c;
  for (int i = 2 + upto(1); i > 0; --i) {
    Stock s;
    for (const Rational &size : {ratio(1, 10), ratio(1, 2), Rational(1), Rational(3)})
      if (size == ratio(1, 10) || upto(3) != 0) {
        s.sizes.push_back(size);
        s.passing.emplace_back(s.passing.empty() ? 0 : upto(100));
      }
    std::sort(s.passing.begin(), s.passing.end());
    s.sizes.emplace_back(8);
    s.passing.emplace_back(100);
    c.stocks.push_back(std::move(s));
    c.costs.push_back(ratio(upto(12), 4));
  }
  Rational middle = 0;
  for (const Stock &s : c.stocks)
    middle += s.modulus() / c.stocks.size();
  c.least = floor(Rational(middle * 100)) / Rational(100) - ratio(upto(60), 100);
  c.most = c.least + ratio(upto(60), 100);
  c.passing_most = 30 + upto(70);
  c.steps = 5 + upto(15);
  return c;
}

/// The least cost of a blend; nothing where there is none.
std::optional<Rational> least_cost(const Case &c) {
  std::optional<Rational> best;
  std::vector<int> counts(c.stocks.size());
  const std::function<void(std::size_t, int)> walk = [&](std::size_t i, int left) {
    if (i + 1 < counts.size()) {
      for (counts[i] = 0; counts[i] <= left; ++counts[i])
        walk(i + 1, left - counts[i]);
      return;
    }
    counts[i] = left;
    Rational modulus = 0, passing = 0, cost = 0;
    for (std::size_t j = 0; j < counts.size(); ++j) {
      const Rational share = ratio(counts[j], c.steps);
      modulus += share * c.stocks[j].modulus();
      passing += share * c.stocks[j].at(1);
      cost += share * c.costs[j];
    }
    if (c.least <= modulus && modulus <= c.most && passing <= c.passing_most)
      best = best ? std::min<Rational>(*best, cost) : cost;
  };
  walk(0, c.steps);
  return best;
}

BlendProblem problem_of(const Case &c) {
  std::vector<Gradation> stockpiles;
  for (std::size_t i = 0; i < c.stocks.size(); ++i)
    stockpiles.push_back(read_gradation(c.stocks[i].file(), std::to_string(i) + ".csv"));
  BlendProblem p = blend_problem(stockpiles, read_envelope(c.limits(), "limits.csv"), std::nullopt,
                                 {{FinenessModulus::en, c.least, c.most}});
  p.steps = static_cast<std::uint64_t>(c.steps);
  p.aim = BlendAim::cost;
  for (std::size_t i = 0; i < c.costs.size(); ++i)
    p.stockpiles[i].cost = c.costs[i];
  return p;
}

checker::Verdict verdict(const Case &c, const std::string &certificate) {
  std::vector<checker::Input> stockpiles;
  std::vector<std::string> files;
  for (const Stock &s : c.stocks)
    files.push_back(s.file());
  for (std::size_t i = 0; i < files.size(); ++i)
    stockpiles.push_back({std::to_string(i) + ".csv", files[i]});
  const std::string limits = c.limits();
  return checker::check_blend({"limits.csv", limits}, stockpiles, {"proof", certificate});
}

/// The certificate with its line `modulus ...` replaced; an empty line takes it away.
std::string with_modulus(const std::string &certificate, const std::string &line) {
  const std::size_t from = certificate.find("\nmodulus ") + 1;
  return certificate.substr(0, from) + line + certificate.substr(certificate.find('\n', from) + 1);
}

} // namespace

TEST_CASE("blends within a fineness modulus are those of enumeration, and proved") {
  std::mt19937 random(12620);
  int blends = 0, none = 0, needed = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const Case c = random_case(random);
    const BlendProblem p = problem_of(c);
    const BlendAnswer a = solve_blend(p);
    const std::optional<Rational> expected = least_cost(c);
    const std::string certificate = blend_certificate(p, a);
    const checker::Verdict v = verdict(c, certificate);
    INFO(trial << "\n" << c.limits() << certificate << v.reason);
    REQUIRE(a.best.empty() == !expected);
    if (expected)
      REQUIRE(a.best.front().value == *expected);
    CHECK(v.code == checker::Verdict::accepted);
    (expected ? blends : none) += 1;
    // The limit must be in the proof where it makes a difference.
    Case free = c;
    free.least = 0;
    free.most = 6;
    if (p.sieves.back().modulus && least_cost(free) != expected) {
      ++needed;
      CHECK(verdict(c, with_modulus(certificate, "")).code != checker::Verdict::accepted);
    }
  }
  CHECK(blends > 100);
  CHECK(none > 50);
  CHECK(needed > 50);
}

TEST_CASE("lines of a modulus that say nothing, or are not in order, are malformed") {
  std::mt19937 random(2);
  Case c = random_case(random);
  while (!least_cost(c))
    c = random_case(random);
  const std::string certificate = blend_certificate(problem_of(c), solve_blend(problem_of(c)));
  for (const char *line :
       {"modulus en 0 6\n", "modulus en 2 1\n", "modulus en 1 7\n", "modulus en 1\n", "modulus fm 1 2\n",
        "modulus en 1 2\nmodulus astm 1 2\n", "modulus en 1 2\nmodulus en 1 2\n", "modulus en 2/2 3\n",
        "modulus en -1 3\n", "modulus en 1 2 3\n"}) {
    CAPTURE(line);
    CHECK(verdict(c, with_modulus(certificate, line)).code == checker::Verdict::malformed);
  }
}

TEST_CASE("moduli that cannot be kept, or of which a stockpile does not tell, are refused") {
  const Gradation g = read_gradation("size_mm,passing_percent\n8,100\n1,40\n0.1,0\n", "a.csv"),
                  coarse = read_gradation("size_mm,passing_percent\n8,100\n1,40\n", "b.csv");
  const Envelope e =
      read_envelope("size_mm,passing_min_percent,passing_max_percent\n8,100,100\n1,0,90\n", "l.csv");
  const auto problem = [&](const Gradation &of, std::vector<ModulusLimits> moduli) {
    return blend_problem({of}, e, std::nullopt, moduli);
  };
  CHECK(problem(g, {{FinenessModulus::en, 2, 3}}).sieves.size() == 3);
  CHECK(problem(g, {{FinenessModulus::en, 0, 6}}).sieves.size() == 2); // no limit
  CHECK_THROWS_AS(problem(coarse, {{FinenessModulus::en, 2, 3}}), InputError);
  CHECK_THROWS_AS(problem(g, {{FinenessModulus::en, 7, std::nullopt}}), InputError);
  CHECK_THROWS_AS(problem(g, {{FinenessModulus::en, 2, 3}, {FinenessModulus::en, 1, 4}}), InputError);
}

} // namespace blend_modulus_test
