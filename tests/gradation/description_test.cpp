#include "gradation/description.hpp"
#include "support.hpp"

#include <random>

namespace description_test {

using namespace mdm;
using namespace mdm::test;

namespace {

Gradation gradation(std::vector<Rational> sizes, std::vector<Rational> masses,
                    std::vector<Rational> factors = {}) {
  Gradation::Data d;
  d.sizes = std::move(sizes);
  d.masses = std::move(masses);
  d.factors = std::move(factors);
  return Gradation(std::move(d));
}

/// Classes (1, 2], (2, 3], (3, 4].
Gradation three_classes() {
  return gradation({1, 2, 3, 4}, {8, 0, 64, 0});
}

std::vector<int> counts(const Description &d) {
  std::vector<int> all;
  for (std::size_t j = 0; j < d.gradation().classes(); ++j)
    all.push_back(static_cast<int>(d.of_class(j).count));
  return all;
}

Rational exactly(const Interval &y) {
  CHECK(y.is_point());
  return y.lo;
}

} // namespace

TEST_CASE("Sample: sizes ascend and are positive, quantities are 1 or more") {
  CHECK(Sample({1, 2}, {3, 4}).particles() == 7);
  CHECK(Sample().particles() == 0);
  CHECK(contains(message_of([] { Sample({1}, {}); }), "there are 0 and 1"));
  CHECK(contains(message_of([] { Sample({0, 1}, {1, 1}); }), "particle size 0 is not above 0"));
  CHECK(contains(message_of([] { Sample({2, 2}, {1, 1}); }), "size 2 does not ascend"));
  CHECK(contains(message_of([] { Sample({2, 1}, {1, 1}); }), "size 1 does not ascend"));
  CHECK(contains(message_of([] { Sample({2}, {0}); }), "quantity of size 2 is not 1 or more"));
}

TEST_CASE("Description: a particle passes an opening of its own size") {
  const Rational little = ratio(1, 1000000000);
  Description d(three_classes());
  for (const int opening : {2, 3})
    for (const Rational &x : {Rational(opening - little), Rational(opening), Rational(opening + little)})
      d.add(x);
  CHECK(counts(d) == std::vector<int>{2, 3, 1});
  CHECK(d.describes());
}

TEST_CASE("Description: Cond2 on both sides of the finest and the largest opening") {
  const Rational little = ratio(1, 1000000000);
  CHECK(Description(three_classes(), Sample({1 + little, 4}, {1, 1})).describes());
  const Description low(three_classes(), Sample({ratio(1, 2), 1, 2}, {3, 2, 1}));
  CHECK_FALSE(low.describes());
  CHECK(low.articulately() == false);
  CHECK(low.below().count == 5);
  CHECK(low.below().first->is(ratio(1, 2), 1));
  CHECK(low.above().count == 0);
  CHECK(low.particles() == 6);
  const Description high(three_classes(), Sample({2, 4 + little}, {1, 7}));
  CHECK_FALSE(high.describes());
  CHECK(high.above().count == 7);
  CHECK(high.above().first->is(4 + little, 1));
  CHECK(Description(gradation({0, 1}, {1, 0}), Sample({little}, {1})).describes());
}

TEST_CASE("Description: Cond3 wants one size in a class") {
  // Eq. 11 as printed would find 2 between 1.5 and 2, and nothing between 2 and 2.5.
  CHECK(Description(three_classes(), Sample({2, ratio(5, 2)}, {1, 1})).articulately() == true);
  const Description d(three_classes(), Sample({ratio(3, 2), 2}, {4, 1}));
  CHECK(d.describes());
  CHECK(d.articulately() == false);
  CHECK(d.inarticulate_class() == 0);
  CHECK(d.of_class(0).first->is(ratio(3, 2), 1));
  CHECK(d.of_class(0).second->is(2, 1));
  Description same(three_classes());
  same.add(4);
  same.add(4, 5);
  CHECK(same.articulately() == true);
  CHECK(counts(same) == std::vector<int>{0, 0, 6});
}

TEST_CASE("Description: Cond4 with masses as given and up to a scale") {
  const MatchError exact = Description(three_classes(), Sample({2, 4}, {1, 1})).error();
  for (std::size_t j = 0; j < 3; ++j) {
    CHECK(exactly(exact.as_given[j]) == 0);
    CHECK(exactly(exact.normalised[j]) == 0);
  }
  CHECK(exactly(exact.total) == 0);
  const MatchError scaled = Description(three_classes(), Sample({2, 4}, {3, 3})).error();
  CHECK(exactly(scaled.as_given[0]) == -16);
  CHECK(exactly(scaled.as_given[2]) == -128);
  CHECK(exactly(scaled.maximum) == 0);
}

TEST_CASE("Description: errors, the worst class and the total") {
  // Masses 2 * 1.5^3 = 6.75, 27 and 64 of 97.75; the targets are 1/9, 0 and 8/9.
  const MatchError e = Description(three_classes(), Sample({ratio(3, 2), 3, 4}, {2, 1, 1})).error();
  CHECK(exactly(e.as_given[0]) == ratio(5, 4));
  CHECK(exactly(e.as_given[1]) == -27);
  CHECK(exactly(e.shares[0]) == ratio(27, 391));
  CHECK(exactly(e.normalised[0]) == ratio(1, 9) - ratio(27, 391));
  CHECK(exactly(e.normalised[1]) == ratio(-108, 391));
  CHECK(e.worst == 1);
  CHECK(exactly(e.maximum) == ratio(108, 391));
  CHECK(exactly(e.total) == ratio(216, 391));
}

TEST_CASE("Description: factors weigh the classes, and particles outside have no share") {
  const Gradation g = gradation({1, 2, 3, 4}, {8, 0, 64, 0}, {2, 1, ratio(1, 2), 1});
  const MatchError e = Description(g, Sample({1, 2, 4}, {9, 1, 1})).error();
  CHECK(exactly(e.shares[0]) == ratio(16, 48));
  CHECK(exactly(e.shares[2]) == ratio(32, 48));
}

TEST_CASE("Description: no particles, no shares") {
  const MatchError e = Description(three_classes()).error();
  CHECK(exactly(e.normalised[0]) == ratio(1, 9));
  CHECK(exactly(e.maximum) == ratio(8, 9));
  CHECK(e.worst == 2);
  CHECK(exactly(e.total) == 1);
}

TEST_CASE("Description: a snap takes sizes near an opening as it, mass and all") {
  const Rational snap = ratio(1, 1000);
  for (const Rational &off : {Rational(-snap), Rational(snap)}) {
    const Rational edge = 1 + off, beyond = 1 + 2 * off;
    Description d(three_classes(), {{}, snap, 1});
    d.add(2 * edge, 3);
    d.add(2 * edge);
    d.add(4 * edge);
    CHECK(counts(d) == std::vector<int>{4, 0, 1});
    CHECK(d.snapped() == 5);
    CHECK(d.articulately() == true);
    CHECK(exactly(d.error().as_given[0]) == 8 - 32);
    d.add(edge, 7); // on the finest opening: it passes
    CHECK(d.below().count == 7);
    CHECK(d.snapped() == 12);
    d.add(2 * beyond);
    d.add(3);
    CHECK(d.snapped() == 12);
    CHECK(counts(d) == (off < 0 ? std::vector<int>{5, 1, 1} : std::vector<int>{4, 2, 1}));
  }
  CHECK(contains(message_of([] {
                   Description(three_classes(), {{}, ratio(1, 7), 1});
                 }),
                 "makes one of the openings 3 and 4"));
  CHECK(contains(message_of([] { Description(three_classes(), {{}, -1, 1}); }), "negative snap"));
}

TEST_CASE("Description: particles a hair above an opening are counted") {
  const Rational hair = ratio(1, power_of_ten(12));
  Description d(three_classes());
  for (const int opening : {1, 2, 3, 4}) {
    d.add(opening * (1 + hair));
    d.add(opening * (1 + 2 * hair), 10);
    d.add(opening, 100);
    d.add(opening * (1 - hair), 1000);
  }
  CHECK(d.hair_above() == 4);
  CHECK(d.above().count == 11);
}

TEST_CASE("Description: laws that are rational at the sizes are exact") {
  const MassLaw law{3, 2};
  Description d(three_classes(), {law, 0, 1});
  d.add(4, 8);
  d.add(ratio(9, 4));
  const MatchError e = d.error();
  CHECK(exactly(e.as_given[2]) == 0);
  CHECK(exactly(e.as_given[1]) == ratio(-27, 8));
}

TEST_CASE("Description: irrational laws are enclosed to 4096 bits") {
  const MassLaw law{1, 2};
  Description d(gradation({1, 2, 3, 4}, {1, 1, 2, 0}), {law, 0, 1});
  d.add(2, 3);
  d.add(3);
  d.add(4);
  const MatchError e = d.error();
  const Rational width = power(ratio(1, 2), 4090);
  // 3 sqrt 2 and sqrt 3: squares decide.
  const Interval t0(1 - e.as_given[0].hi, 1 - e.as_given[0].lo);
  CHECK(t0.hi - t0.lo < width);
  CHECK(t0.lo * t0.lo < 18);
  CHECK(t0.hi * t0.hi > 18);
  const Interval t1(1 - e.as_given[1].hi, 1 - e.as_given[1].lo);
  CHECK(t1.lo * t1.lo < 3);
  CHECK(t1.hi * t1.hi > 3);
  CHECK(exactly(e.as_given[2]) == 0);
  CHECK(e.maximum.hi - e.maximum.lo < width);
  CHECK(e.worst == 0);
  CHECK(e.shares[2].lo > ratio(2506, 10000)); // 2 / (3 sqrt 2 + sqrt 3 + 2)
  CHECK(e.shares[2].hi < ratio(2509, 10000));
}

TEST_CASE("Description: sizes that are roots are judged by their powers") {
  // x^3 = 8 is on the opening 2; masses in units of u with u^1 = 4.
  Description d(three_classes(), {{}, 0, 4});
  d.add(RootSize{8, 3}, 1);
  d.add(RootSize{9, 3}, 2);
  d.add(RootSize{27, 3}, 1);
  d.add(RootSize{1, 3}, 1);
  CHECK(counts(d) == std::vector<int>{1, 3, 0});
  CHECK(d.below().count == 1);
  CHECK(d.of_class(1).first->is(9, 3));
  CHECK(d.inarticulate_class() == 1);
  CHECK(exactly(d.error().as_given[0]) == 0);
  // Law x^(1/2), both classes hold multiples of the unit sqrt 2: exact shares.
  Description roots(gradation({1, 4, 9}, {1, 1, 0}), {{1, 2}, 0, 2, 2});
  roots.add(RootSize{2, 1}, 2);
  roots.add(RootSize{8, 1}, 1);
  const MatchError e = roots.error();
  CHECK(exactly(e.normalised[0]) == 0);
  CHECK_FALSE(e.as_given[0].is_point());
}

TEST_CASE("Description: agrees with sums class by class on random samples") {
  std::mt19937 random(7);
  const auto draw = [&random](int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random);
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<Rational> sizes{draw(0, 1)}, masses;
    while (sizes.size() < 5)
      sizes.push_back(sizes.back() + ratio(draw(1, 30), 10));
    for (std::size_t j = 0; j < 4; ++j)
      masses.push_back(draw(0, 9));
    masses[2] += 1;
    masses.push_back(0);
    const Gradation g = gradation(sizes, masses);
    const MassLaw law{static_cast<unsigned>(draw(1, 4)), 1};
    Description d(g, {law, 0, 1});
    std::vector<Rational> expected(4, Rational(0));
    Rational all = 0, target = 0;
    int outside = 0;
    for (int i = 0; i < 30; ++i) {
      const Rational x = ratio(draw(1, 130), 10);
      const int q = draw(1, 5);
      d.add(x, q);
      bool found = false;
      for (std::size_t j = 0; j < 4; ++j)
        if (sizes[j] < x && x <= sizes[j + 1]) {
          found = true;
          Rational f = 1;
          for (unsigned k = 0; k < law.a; ++k)
            f *= x;
          expected[j] += q * f;
          all += q * f;
        }
      outside += found ? 0 : q;
    }
    for (const Rational &m : masses)
      target += m;
    CHECK(d.below().count + d.above().count == outside);
    CHECK(d.describes() == (outside == 0));
    const MatchError e = d.error();
    Rational largest = 0, total = 0;
    for (std::size_t j = 0; j < 4; ++j) {
      CHECK(exactly(e.as_given[j]) == masses[j] - expected[j]);
      const Rational error = masses[j] / target - (all == 0 ? Rational(0) : Rational(expected[j] / all));
      CHECK(exactly(e.normalised[j]) == error);
      largest = std::max(largest, Rational(abs(error)));
      total += abs(error);
    }
    CHECK(exactly(e.maximum) == largest);
    CHECK(abs(e.normalised[e.worst].lo) == largest);
    CHECK(exactly(e.total) == total);
  }
}

} // namespace description_test
