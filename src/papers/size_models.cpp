#include "papers/size_models.hpp"

#include "sets/set_sizes.hpp"
#include "sets/size_distribution.hpp"

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned discs = 2;
constexpr unsigned quality_points = 100;
constexpr unsigned drawn_digits = 15;

/// Questions with geometric and with regular classes for all compared shapes; `vary` makes those of one.
template <class Vary>
std::vector<SetQuestion> questions(Vary vary) {
  std::vector<SetQuestion> all;
  for (const Classing classing : {Classing::geometric, Classing::regular})
    for (const Shape &shape : compared_shapes()) {
      SetQuestion question;
      question.shape = shape;
      question.classing = classing;
      vary(question, all);
    }
  return all;
}

/// 1, 2, 5, 10, ... from `least` to `most`.
std::vector<Integer> round_numbers(unsigned least, unsigned most) {
  std::vector<Integer> numbers;
  for (unsigned power = least; power <= most; power *= 10)
    for (const unsigned factor : {1U, 2U, 5U})
      if (power * factor <= most)
        numbers.emplace_back(power * factor);
  return numbers;
}

} // namespace

BetaCurve spanned_curve(const Shape &shape, const Rational &span) {
  return BetaCurve(shape.a, shape.b, 1, (1 + span) / (1 - span));
}

std::vector<Shape> compared_shapes() {
  return {{1, 3}, {3, 3}, {3, 1}};
}

std::vector<DistributionRow> figure1_rows() {
  constexpr unsigned n = 100;
  const BetaCurve curve(3, 3, ratio(1, 1000), ratio(1, 100));
  std::vector<Real> bounds, shares;
  for (const SizeClass &c : size_classes(curve, Classing::regular, n)) {
    bounds.push_back(c.lower.real);
    shares.push_back(c.volume_fraction);
  }
  bounds.emplace_back(curve.d_max());
  const SizeDistribution set = SizeDistribution::by_volume(std::move(bounds), std::move(shares), discs);
  std::vector<DistributionRow> rows;
  for (unsigned i = 0; i < n; ++i) {
    const Rational size = curve.d_min() + (curve.d_max() - curve.d_min()) * ratio(2 * i + 1, 2 * n);
    rows.push_back(
        {size, set.number_density(size), set.volume_density(size), set.partition(size), set.grading(size)});
  }
  return rows;
}

std::vector<PassingRow> figure3_rows() {
  constexpr unsigned pieces = 200;
  std::vector<PassingRow> rows;
  for (const Shape &shape :
       std::vector<Shape>{{1, 1}, {1, 3}, {3, 1}, {3, 3}, {2, 4}, {4, 2}, {ratio(1, 10), ratio(1, 10)}}) {
    const BetaCurve curve(shape.a, shape.b, 1, 2);
    for (unsigned i = 0; i <= pieces; ++i) {
      const Rational t = ratio(i, pieces), reduced = power(t, 3) * (10 - 15 * t + 6 * t * t);
      rows.push_back({shape, reduced, curve.passing(Real(Rational(1 + reduced)))});
    }
  }
  return rows;
}

CoefficientRow coefficient_row(const Shape &shape, const Rational &span) {
  const BetaCurve curve = spanned_curve(shape, span);
  return {shape, span, uniformity(curve), curvature(curve)};
}

std::vector<CoefficientRow> figure4_rows() {
  std::vector<CoefficientRow> rows;
  for (const Shape &shape : std::vector<Shape>{{1, 1}, {1, 3}, {2, 4}, {3, 1}, {4, 2}, {4, 4}})
    for (unsigned i = 1; i < 50; ++i)
      rows.push_back(coefficient_row(shape, ratio(i, 50)));
  return rows;
}

std::vector<SetQuestion> figure5_questions() {
  return questions([](SetQuestion question, std::vector<SetQuestion> &all) {
    for (question.classes = 1; question.classes <= 30; ++question.classes)
      all.push_back(question);
  });
}

std::vector<SetQuestion> figure6_questions() {
  return questions([](SetQuestion question, std::vector<SetQuestion> &all) {
    for (const Integer &n : round_numbers(1, 200)) {
      question.wanted.min_per_class = n;
      all.push_back(question);
    }
  });
}

std::vector<SetQuestion> figure7_questions() {
  return questions([](SetQuestion question, std::vector<SetQuestion> &all) {
    for (const Integer &n : round_numbers(100, 200000)) {
      question.wanted.at_least = n;
      all.push_back(question);
    }
  });
}

SetRow set_row(const SetQuestion &question, const Integer &most_drawn) {
  const BetaCurve curve = spanned_curve(question.shape, ratio(49, 50));
  const std::vector<SizeClass> classes = size_classes(curve, question.classing, question.classes);
  SetRow row{question, class_counts(classes, curve, question.wanted), {}};
  if (row.counts.decided() && row.counts.particles() <= most_drawn)
    for (unsigned seed = 1; seed <= draws_of_a_set; ++seed)
      row.c_r.push_back(set_quality(curve, classes, question.wanted.dimension, quality_points,
                                    drawn_particles(classes, row.counts.numbers, question.wanted.dimension,
                                                    drawn_digits, Draws::random(seed)))
                            .c_r);
  return row;
}

Interval SetRow::mean() const {
  Interval sum(0);
  for (const Interval &one : c_r)
    sum = sum + one;
  return {Rational(sum.lo / c_r.size()), Rational(sum.hi / c_r.size())};
}

Interval SetRow::least() const {
  Interval least = c_r.front();
  for (const Interval &one : c_r)
    least = {std::min(least.lo, one.lo), std::min(least.hi, one.hi)};
  return least;
}

Interval SetRow::greatest() const {
  Interval greatest = c_r.front();
  for (const Interval &one : c_r)
    greatest = mdm::greater(greatest, one);
  return greatest;
}

ShapeRow shape_row(const ShapeQuestion &question) {
  const SetQuestion defaults;
  const BetaCurve curve = spanned_curve(question.shape, question.span);
  const ClassCounts counts =
      class_counts(size_classes(curve, question.classing, defaults.classes), curve, defaults.wanted);
  return {question, std::max(counts.estimated().hi, defaults.wanted.at_least), uniformity(curve)};
}

std::vector<ShapeQuestion> figure8_maps() {
  std::vector<ShapeQuestion> all;
  for (const Classing classing : {Classing::regular, Classing::geometric})
    for (const Rational &span : {ratio(1, 10), ratio(97, 100)})
      for (unsigned a = 1; a <= 24; ++a)
        for (unsigned b = 1; b <= 24; ++b)
          all.push_back({classing, span, {ratio(a, 2), ratio(b, 2)}});
  return all;
}

std::vector<ShapeQuestion> figure8_spans() {
  std::vector<ShapeQuestion> all;
  for (unsigned i = 1; i <= 20; ++i)
    for (unsigned a = 1; a <= 10; ++a)
      for (unsigned b = 1; b <= 10; ++b)
        all.push_back({Classing::regular, ratio(i == 20 ? 97 : 5 * i, 100), {a, b}});
  return all;
}

} // namespace mdm
