#include "brute_force.hpp"
#include "catch.hpp"
#include "plain_gradation.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

namespace solve_test {

using namespace mdm;

namespace {

/// Every statement of a match of spheres, from the definitions.
void check_match(const Match &m) {
  const MatchScale &scale = *m.sample->scale;
  CHECK(scale.window.above < scale.chosen);
  CHECK(scale.chosen <= scale.window.up_to);
  const std::vector<MatchClass> classes = m.classes();
  REQUIRE(classes.size() == m.gradation.classes());
  Rational all = 0, volume = 0;
  for (const Rational &mass : m.gradation.masses())
    all += mass;
  for (std::size_t j = 0; j < classes.size(); ++j) {
    const MatchClass &c = classes[j];
    CHECK(c.lower.is(m.gradation.lower(j), 1));
    CHECK(c.upper.is(m.gradation.upper(j), 1));
    CHECK(c.mass == m.gradation.mass(j));
    CHECK(c.share == c.mass / all);
    CHECK((c.mass > 0) == (c.quantity > 0));
    REQUIRE((c.quantity > 0) == c.size.has_value());
    if (!c.size)
      continue;
    const Rational cube = scale.chosen * c.mass / (m.gradation.factor(j) * Rational(c.quantity));
    const Enclosure &x = *c.size;
    volume += cube * Rational(c.quantity);
    CHECK(m.gradation.lower(j) < x.lower());
    CHECK(x.upper() <= m.gradation.upper(j));
    if (x.lo == x.hi) {
      CHECK(power(x.lower(), 3) == cube);
    } else {
      CHECK(power(x.lower(), 3) < cube);
      CHECK(cube < power(x.upper(), 3));
    }
    // The margin is certain: sizes are at least that far from both sieves.
    CHECK(x.upper() >= m.gradation.lower(j) * (1 + scale.margin));
    CHECK(x.lower() * (1 + scale.margin) <= m.gradation.upper(j));
  }
  const Rational pi_below = ratio(314159265, 100000000), pi_above = ratio(314159266, 100000000);
  CHECK(m.solids_volume()->upper() > volume * pi_below / 6);
  CHECK(m.solids_volume()->lower() < volume * pi_above / 6);
}

} // namespace

TEST_CASE("a match satisfies its definition") {
  std::mt19937_64 random(13);
  for (int i = 0; i < 500; ++i) {
    const Gradation g = brute::random_gradation(random);
    SolveOptions options;
    options.scale = random() % 2 == 0 ? ScaleChoice::automatic : ScaleChoice::upper;
    options.digits = 1 + static_cast<unsigned>(random() % 20);
    const Match m = solve(g, {}, options);
    CHECK(m.status == Status::optimal);
    check_match(m);
  }
}

TEST_CASE("the robust scale is near the geometric middle") {
  std::mt19937_64 random(14);
  for (int i = 0; i < 500; ++i) {
    const Match m = solve(brute::random_gradation(random));
    const MatchScale &scale = *m.sample->scale;
    const Rational &lo = scale.window.above, &hi = scale.window.up_to;
    if (lo == 0) {
      CHECK(scale.chosen == hi / 2);
      continue;
    }
    CHECK(scale.chosen * scale.chosen >= lo * hi);
    const Rational less = scale.chosen - (hi - lo) / 100;
    CHECK((less <= 0 || less * less <= lo * hi));
  }
}

TEST_CASE("a cylinder's volume is met exactly where it can be") {
  Question q;
  q.solids = parse_specimen("cylinder:50x24.4", "0.683", SizeUnit::mm);
  const Gradation g = gradation({1, 2, 3}, {2, 1, 0});
  const Match m = solve(g, q);
  check_match(m);
  const MatchScale &scale = *m.sample->scale;
  REQUIRE(scale.window.start.has_value());
  const Rational s0 = scale.window.start->lo;
  CHECK(s0 == ratio(3 * 2500, 1) * parse_decimal("24.4") / (2 * parse_decimal("1.683") * 3));
  CHECK(scale.chosen == (scale.window.above < s0 ? s0 : scale.chosen));
  CHECK(scale.chosen >= s0);
}

TEST_CASE("a start at the very end of the window leaves a single scale") {
  // One class (1, 2] of mass 1: with s >= 8 q exactly, q particles of the largest size.
  Question q;
  // s_0 = 3 D^2 H / (2 (1 + e) W) = 24 with D = 2, H = 4, e = 0, W = 1.
  q.solids = Cylinder{2, 4, 0};
  const Match m = solve(gradation({1, 2}, {1, 0}), q);
  CHECK(m.particles() == 3);
  CHECK(m.sample->scale->chosen == 24);
  CHECK(m.sample->scale->window.up_to == 24);
  CHECK(m.sample->sizes[0]->text() == "2");
  CHECK(m.sample->scale->margin == 0);
  CHECK(m.notes.size() == 2); // of double precision, and of the specimen
}

TEST_CASE("a volume with pi is reached, and closely") {
  for (const char *volume : {"1", "12.5", "1000", "0.001"}) {
    Question q;
    q.solids = SolidsVolume{parse_decimal(volume)};
    const Match m = solve(gradation({1, 2, 3}, {2, 1, 0}), q);
    check_match(m);
    REQUIRE(m.proof.pi.has_value());
    const Enclosure v = m.solids_volume().value();
    CHECK(v.upper() >= parse_decimal(volume));
    if (m.sample->scale->window.start_is_feasible())
      CHECK(v.lower() <= parse_decimal(volume));
  }
}

TEST_CASE("a volume whose lower scale bound is the window's end is met") {
  // s_0 = 6 V / pi = 27 (pi + 10^-45) / pi, a little above the window's open end 27; the first bounds of pi
  // touch it.
  Gradation::Data data;
  data.sizes = {3, 6};
  data.masses = {1, 0};
  Question q;
  q.solids =
      SolidsVolume{parse_decimal("4.5") * parse_decimal("3.141592653589793238462643383279502884197169400")};
  const Match m = solve(Gradation(data), q);
  check_match(m);
  CHECK(m.particles() == 1);
  CHECK(m.sample->scale->chosen < 28);
}

TEST_CASE("a size that is an opening and no decimal is refused") {
  SolveOptions options;
  options.scale = ScaleChoice::upper;
  CHECK_THROWS_AS(solve(gradation({ratio(1, 7), ratio(1, 3)}, {1, 0}), {}, options), InputError);
  CHECK_NOTHROW(solve(gradation({ratio(1, 7), ratio(1, 3)}, {1, 0})));
}

TEST_CASE("a specimen needs spheres") {
  Question q;
  q.law = {2, 1};
  q.solids = Cylinder{1, 1, 0};
  CHECK_THROWS_AS(solve(gradation({1, 2}, {1, 0}), q), InputError);
  for (const char *shape :
       {"cylinder:1", "cylinder:1x2x3", "box:1x2", "box:1x2x", "ball:3", "cylinder:0x1", "cylinder:-1x1", ""})
    CHECK_THROWS_AS(parse_specimen(shape, "0.5", SizeUnit::mm), InputError);
  CHECK_THROWS_AS(parse_specimen("cylinder:1x1", "-0.5", SizeUnit::mm), InputError);
}

TEST_CASE("a specimen's lengths may have units, and are named with the gradation's") {
  Question q;
  q.solids = parse_specimen("cylinder:5mmx0.4in", "0.6", SizeUnit::um);
  CHECK(std::get<Cylinder>(*q.solids).diameter == 5000);
  CHECK(std::get<Cylinder>(*q.solids).height == 10160);
  CHECK(in_words(q, SizeUnit::um) ==
        "at least the solids of a cylinder 5000 um x 10160 um at void ratio 0.6");
  q.solids = parse_specimen("box:1x20mmx0.3", "0", SizeUnit::m);
  q.pan_size = ratio(1, 100000);
  q.cut_below = ratio(1, 1000);
  CHECK(in_words(q, SizeUnit::m) == "at least the solids of a box 1 m x 0.02 m x 0.3 m at void ratio 0; pan "
                                    "counted as size 0.00001 m; classes below 0.001 m left out");
}

TEST_CASE("a size next to its sieve gets the digits that keep it inside its class") {
  // The window is (1, 1 + 10^-30]: sizes agree with the sieve for thirty digits.
  const Rational tiny = ratio(1, power_of_ten(30));
  const Match m = solve(gradation({1, 1 + tiny}, {1, 0}));
  CHECK(m.particles() == 1);
  check_match(m);
  CHECK(to_string(m.sample->sizes[0]->lo).size() > 30);
  CHECK(m.notes.size() == 2); // digits, and doubles that cannot hold it
}

TEST_CASE("at-most decides the verdict") {
  const Gradation g = gradation({1, 2, 3}, {2, 1, 0});
  SolveOptions options;
  options.at_most = 4;
  CHECK(solve(g, {}, options).status == Status::optimal);
  options.at_most = 3;
  const Match none = solve(g, {}, options);
  CHECK(none.status == Status::none);
  CHECK(none.lower_bound == 4);
}

TEST_CASE("a sweep ends when there are more particles than may be for certain") {
  // The whole sweep has some 10^20 steps.
  const Rational tiny = ratio(1, power_of_ten(20));
  const Gradation g = gradation({1, 1 + tiny, 1 + 2 * tiny, 1 + 4 * tiny, 2}, {1, ratio(13, 10), 3, 7, 0});
  SolveOptions options;
  options.at_most = 5;
  const Match none = solve(g, {}, options);
  CHECK(none.status == Status::none);
  CHECK(none.lower_bound > 5);
}

TEST_CASE("a limit leaves a match and a bound") {
  std::mt19937_64 random(15);
  for (int i = 0; i < 200; ++i) {
    const Gradation g = brute::random_gradation(random);
    Question q;
    q.at_least = static_cast<int>(1 + random() % 30);
    const Integer n = solve(g, q).particles().value();
    SolveOptions options;
    options.limits.max_steps = random() % 3;
    const Match m = solve(g, q, options);
    check_match(m);
    CHECK(m.lower_bound <= n);
    CHECK(n <= m.particles());
    CHECK((m.status == Status::optimal) == m.complete);
  }
}

TEST_CASE("pan size, cut and size factor change the gradation in this order") {
  Question q;
  q.pan_size = 1;
  q.cut_below = 2;
  q.size_factor = 3;
  const Gradation g = asked_gradation(gradation({0, 2, 4, 8}, {1, 2, 3, 0}), q);
  CHECK(g.sizes() == std::vector<Rational>{6, 12, 24});
  q.pan_size = 2;
  CHECK_THROWS_AS(asked_gradation(gradation({0, 2, 4, 8}, {1, 2, 3, 0}), q), InputError);
  q.pan_size = std::nullopt;
  q.cut_below = 3;
  CHECK_THROWS_AS(asked_gradation(gradation({0, 2, 4, 8}, {1, 2, 3, 0}), q), InputError);
}

TEST_CASE("powers that get out of hand are refused") {
  Question q;
  q.law = {1000, 999};
  const Rational size = parse_decimal("1." + std::string(900, '7'));
  CHECK_THROWS_AS(solve(gradation({size, size + 1}, {1, 0}), q), InputError);
}

} // namespace solve_test
