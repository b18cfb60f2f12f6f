#include "brute_force.hpp"
#include "catch.hpp"
#include "match/fixed_size.hpp"
#include "match/least_match.hpp"
#include "match/spanned_integer.hpp"

#include <mdm/gradation/read_gradation.hpp>
#include <mdm/text/error.hpp>

#include <fstream>
#include <map>
#include <sstream>

namespace published_test {

using namespace mdm;

namespace {

using Vector = std::vector<Integer>;

/// The published code's answer to a gradation.
struct FloatAnswer {
  std::uint64_t iterations;
  Vector q;
};

std::map<std::string, FloatAnswer> float_answers(const std::string &factor) {
  std::ifstream file(MDM_DATA_DIR "/suite-2750-float-answers.csv");
  REQUIRE(file.good());
  std::map<std::string, FloatAnswer> answers;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    std::string id, x_n_factor, iterations, sizes, quantities, word;
    std::getline(fields, id, ',');
    std::getline(fields, x_n_factor, ',');
    std::getline(fields, iterations, ',');
    std::getline(fields, sizes, ',');
    std::getline(fields, quantities, ',');
    if (x_n_factor != factor)
      continue;
    FloatAnswer answer{std::stoull(iterations), {}};
    for (std::istringstream words(quantities); words >> word;)
      answer.q.emplace_back(word);
    answers.emplace(id, answer);
  }
  return answers;
}

std::vector<Gradation> suite() {
  std::ifstream file(MDM_SUITE);
  REQUIRE(file.good());
  std::vector<Gradation> gradations;
  for (std::string line; std::getline(file, line);)
    gradations.push_back(read_json_gradation(line, "suite", ""));
  return gradations;
}

Gradation gradation(std::vector<Rational> sizes, std::vector<Rational> masses) {
  Gradation::Data data;
  data.sizes = std::move(sizes);
  data.masses = std::move(masses);
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

} // namespace

TEST_CASE("with one size x_nS the spanned integer algorithm gives the published code's answers") {
  const auto differing = [](const char *factor, const Rational &start) {
    std::map<std::string, FloatAnswer> answers = float_answers(factor);
    std::vector<std::string> ids;
    for (const Gradation &g : suite()) {
      const Published run = spanned_integer(g, {}, {start, 1, 999});
      const FloatAnswer &answer = answers.at(g.id());
      if (run.result().q != answer.q || run.result().multiple != answer.iterations)
        ids.push_back(g.id());
      CHECK(run.is_match());
    }
    return ids;
  };
  CHECK(differing("0.5", ratio(1, 2)).empty());
  // Its answers to these four are no matches: it takes one particle where the span is below 1.
  CHECK(differing("0.001", ratio(1, 1000)) == std::vector<std::string>{"g0363", "g0915", "g0946", "g1650"});
}

TEST_CASE("ratios are those of Eq. 15-17") {
  const Gradation g = gradation({1, 2, 4}, {1, 5});
  const std::vector<Rational> phi = mass_ratios(g);
  CHECK(phi == std::vector<Rational>{ratio(1, 5), 1});
  const std::vector<Rational> zeta = volume_ratios(particle_masses(g, {}, {Rational(1)}), 1);
  CHECK(zeta == std::vector<Rational>{8, 1});
  CHECK(quantity_ratios(phi, zeta) == std::vector<Rational>{ratio(8, 5), 1});
}

TEST_CASE("a class's size is chosen by position or by volume") {
  const Gradation g = gradation({0, 2, 4}, {1, 5});
  CHECK(particle_masses(g, {}, {ratio(1, 2)}) == std::vector<Rational>{1, 27});
  CHECK(particle_masses(g, {}, {Rational(1)}) == std::vector<Rational>{8, 64});
  CHECK(particle_masses(g, {}, {}) == std::vector<Rational>{4, 36});
  CHECK(particle_masses(g, {2, 1}, {}) == std::vector<Rational>{2, 10});
  CHECK_THROWS_AS(particle_masses(g, {5, 2}, {}), InputError);
}

TEST_CASE("int() rounds as asked, ties included") {
  const auto all = [](const Rational &r) {
    return std::vector<Integer>{rounded(r, Rounding::nearest), rounded(r, Rounding::even),
                                rounded(r, Rounding::up), rounded(r, Rounding::down)};
  };
  CHECK(all(ratio(1, 2)) == std::vector<Integer>{1, 0, 1, 0});
  CHECK(all(ratio(3, 2)) == std::vector<Integer>{2, 2, 2, 1});
  CHECK(all(ratio(5, 2)) == std::vector<Integer>{3, 2, 3, 2});
  CHECK(all(ratio(8, 3)) == std::vector<Integer>{3, 3, 3, 2});
  CHECK(all(ratio(7, 3)) == std::vector<Integer>{2, 2, 3, 2});
  CHECK(all(7) == std::vector<Integer>{7, 7, 7, 7});
}

TEST_CASE("the fixed size algorithm multiplies K until the error is within the tolerance") {
  // Sizes 2 and 4, masses 8 and 64, K = 8/5: 2, 3, 5, 6, 8 particles of the finer size to 1, ..., 5.
  const Gradation g = gradation({1, 2, 4}, {1, 5});
  FixedSizeOptions options;
  options.sizes.position = 1;
  options.tolerance = 0;
  const Published run = fixed_size(g, {}, options);
  REQUIRE(run.tries.size() == 5);
  std::vector<Rational> totals;
  std::vector<Integer> finer;
  for (const PublishedTry &t : run.tries) {
    totals.push_back(t.error.total);
    finer.push_back(t.q[0]);
    CHECK(t.q[1] == t.multiple);
  }
  CHECK(finer == std::vector<Integer>{2, 3, 5, 6, 8});
  CHECK(totals == std::vector<Rational>{ratio(1, 15), ratio(1, 57), ratio(1, 87), ratio(1, 57), 0});
  CHECK(run.tries[0].error.of_class == std::vector<Rational>{ratio(-1, 30), ratio(1, 30)});
  CHECK(run.tries[0].error.maximum == ratio(1, 30));
  CHECK(run.reached);
  CHECK(run.is_match());
  CHECK(run.powers == std::vector<Rational>{8, 64});

  options.tolerance = ratio(1, 57); // closed
  CHECK(fixed_size(g, {}, options).tries.size() == 2);
  options.tolerance = 0;
  options.max_iterations = 4;
  CHECK_FALSE(fixed_size(g, {}, options).reached);
}

TEST_CASE("rounding down can leave a class empty, and the error says so") {
  FixedSizeOptions options;
  options.sizes.position = 1;
  options.rounding = Rounding::down;
  options.max_iterations = 1;
  const Published run = fixed_size(gradation({1, 2, 4}, {1, 15}), {}, options);
  CHECK(run.result().q == Vector{0, 1});
  // Eq. 13: target minus held.
  CHECK(run.result().error.of_class == std::vector<Rational>{ratio(1, 16), ratio(-1, 16)});
  CHECK(run.powers[0] == 0);
}

TEST_CASE("empty classes have no particles, and the coarsest class with mass is the reference") {
  const Gradation g = gradation({0, 1, 2, 4, 8}, {3, 0, 5, 0});
  CHECK(reference_class(g) == 2);
  CHECK(mass_ratios(g) == std::vector<Rational>{ratio(3, 5), 0, 1, 0});
  const Published fixed = fixed_size(g, {});
  CHECK(fixed.result().q[1] == 0);
  CHECK(fixed.result().q[3] == 0);
  const Published spanned = spanned_integer(g, {});
  CHECK(spanned.is_match());
  CHECK(spanned.result().q[1] == 0);
  CHECK(spanned.result().q[2] == 1);
  CHECK(spanned.result().q[3] == 0);
  CHECK_FALSE(spanned.most_zeta[0]); // down to the size 0
}

TEST_CASE("the spanned integer algorithm finds the least match where a size that it tries has one") {
  const Gradation g = gradation({1, 2, 3}, {2, 1});
  const Published run = spanned_integer(g, {}, {ratio(1, 1000), 10, 10});
  CHECK(run.is_match());
  CHECK(run.result().q == Vector{3, 1});
  CHECK(total(run.result().q) == total(*brute::least_match(brute::problem(g, 1), 100)));
  // 3 particles hold twice the mass of one of size 2.001.
  CHECK(run.powers[0] * 3 == 2 * run.powers[1]);
}

TEST_CASE("the spanned integer algorithm jumps over a window between two of its sizes") {
  const Gradation g = gradation({2, 3, 4, 6}, {1, 7, 11});
  const Published coarse = spanned_integer(g, {}, {ratio(1, 1000), 10, 10});
  CHECK(coarse.is_match());
  CHECK(coarse.result().q == Vector{1, 2, 1});
  CHECK(*brute::least_match(brute::problem(g, 1), 100) == Vector{1, 1, 1});
  CHECK(spanned_integer(g, {}, {ratio(1, 1000), 100, 10}).result().q == Vector{1, 1, 1});
}

TEST_CASE("the printed test accepts a size on the open end of its class, which is no match") {
  // With x_nS = 4 the finer class spans the integer 1 at its lower sieve 2 alone.
  const Gradation g = gradation({2, 3, 4}, {1, 8});
  const Published run = spanned_integer(g, {}, {ratio(1, 1000), 100, 10});
  CHECK(run.reached);
  CHECK(run.result().sizes == 100);
  CHECK(run.result().q == Vector{1, 1});
  CHECK(run.powers == std::vector<Rational>{8, 64});
  CHECK_FALSE(run.is_match());
  CHECK(total(*brute::least_match(brute::problem(g, 1), 1000)) == 3);
}

TEST_CASE("iterations without an integer in every span are judged by their sizes") {
  // With x_nS = 3.5 the finer class needs 0.2 to 0.7 particles; one of Eq. 19 lies below its class.
  const Gradation g = gradation({2, 3, 4}, {1, 8});
  const Published run = spanned_integer(g, {}, {ratio(1, 2), 1, 1});
  CHECK_FALSE(run.reached);
  CHECK(run.result().q == Vector{1, 1});
  CHECK(run.powers[0] < 8);
  CHECK(run.result().error.of_class == std::vector<Rational>{ratio(1, 9), ratio(-1, 9)});
}

TEST_CASE("the published algorithms never beat the least match") {
  std::mt19937_64 random(7);
  for (int n = 0; n < 300; ++n) {
    const Gradation g = brute::random_gradation(random);
    const Integer least = total(least_match(Problem(g, {}, 1)).q);
    for (const std::uint64_t increments : {1UL, 7UL}) {
      const Published run = spanned_integer(g, {}, {ratio(1, 3), increments, 50});
      if (run.is_match())
        CHECK(total(run.result().q) >= least);
      for (std::size_t j = 0; run.is_match() && j < g.classes(); ++j)
        CHECK((g.mass(j) == 0 ||
               (run.powers[j] > power(g.lower(j), 3) && run.powers[j] <= power(g.upper(j), 3))));
    }
    FixedSizeOptions options;
    options.max_iterations = 30;
    const Published run = fixed_size(g, {}, options);
    if (run.is_match())
      CHECK(total(run.result().q) >= least);
  }
}

} // namespace published_test
