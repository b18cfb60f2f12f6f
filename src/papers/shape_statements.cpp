// The words for shapes in Voivret, Delenne and Radjai, section 2.1. The paper says them of grading curves;
// most are true of the volume density h' alone. For shapes of each kind h is taken at twelve equally spaced
// sizes. The signs of its first differences tell whether the curve rises; those of the second, whether the
// curve is convex and the density rises; those of the third, whether the density is convex. Signs are
// decided, zeros by exact values. Eleven steps, not twelve: the middle of a symmetric curve is no size among
// them, where a difference would be 0 without a way to tell.

#include "papers/model_statements.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

constexpr unsigned steps = 11;

std::vector<Real> differences(const std::vector<Real> &values) {
  std::vector<Real> all;
  for (std::size_t i = 1; i < values.size(); ++i)
    all.push_back(values[i] - values[i - 1]);
  return all;
}

char sign_of(const Real &y) {
  switch (compare(y, 0)) {
  case Order::less:
    return '-';
  case Order::greater:
    return '+';
  case Order::equal:
    return '0';
  default:
    return '?';
  }
}

/// The signs, each run of one sign once: `+-`.
std::string signs(const std::vector<Real> &values) {
  std::string runs;
  for (const Real &y : values)
    if (const char sign = sign_of(y); runs.empty() || runs.back() != sign)
      runs += sign;
  return runs;
}

/// h at 0, 1/11, ..., 1, and its differences.
std::vector<std::vector<Real>> differences_of(const Shape &shape) {
  const BetaCurve curve(shape.a, shape.b, 1, 2);
  std::vector<std::vector<Real>> all(1);
  for (unsigned i = 0; i <= steps; ++i)
    all[0].push_back(curve.passing(Real(Rational(1 + ratio(i, steps)))));
  for (int order = 1; order <= 3; ++order)
    all.push_back(differences(all.back()));
  return all;
}

bool is_mirrored(const std::vector<Real> &values) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (compare(values[i], values[values.size() - 1 - i]) != Order::equal)
      return false;
  return true;
}

/// What a word asks for: a run of signs of the differences of a function, of so many orders.
struct Word {
  const char *word;
  const char *signs; ///< null: the values themselves are the same from both ends
  std::size_t order;
};

constexpr Word word_u_shaped{"U-shaped", "-+", 1}, word_falling{"strictly decreasing", "-", 1},
    word_rising{"strictly increasing", "+", 1}, word_convex{"strictly convex", "+", 2},
    word_straight{"a straight line", "0", 2}, word_concave{"strictly concave", "-", 2},
    word_uniform{"uniform over [0; 1]", "0", 1}, word_unimodal{"unimodal", "+-", 1},
    word_double_curved{"double curved", "+-", 2}, word_symmetric{"symmetric with respect to 1/2", nullptr, 0};

/// True of the function whose differences are those of h from order `of` on: 0 the curve, 1 the density.
bool is_true(const Word &word, const std::vector<std::vector<Real>> &all, std::size_t of) {
  const std::size_t order = of + word.order;
  if (order >= all.size())
    return false;
  return word.signs == nullptr ? is_mirrored(all[order]) : signs(all[order]) == word.signs;
}

/// A row of the paper's lists, with shapes of its kind.
struct ShapeWord {
  const char *shapes;
  const Word *word;
  std::vector<Shape> examples;
};

std::vector<ShapeWord> shape_words() {
  const Rational half = ratio(1, 2), more = ratio(3, 2);
  return {{"a < 1, b < 1", &word_u_shaped, {{half, half}, {half, ratio(1, 4)}}},
          {"a < 1, b >= 1 or a = 1, b > 1", &word_falling, {{half, 1}, {half, 2}, {1, 3}}},
          {"a = 1, b > 2", &word_convex, {{1, 3}, {1, 4}}},
          {"a = 1, b = 2", &word_straight, {{1, 2}}},
          {"a = 1, 1 < b < 2", &word_concave, {{1, more}}},
          {"a = 1, b = 1", &word_uniform, {{1, 1}}},
          {"a = 1, b < 1 or a > 1, b <= 1", &word_rising, {{1, half}, {2, half}, {3, 1}}},
          {"a > 2, b = 1", &word_convex, {{3, 1}, {4, 1}}},
          {"a = 2, b = 1", &word_straight, {{2, 1}}},
          {"1 < a < 2, b = 1", &word_concave, {{more, 1}}},
          {"a > 1, b > 1", &word_unimodal, {{3, 3}, {2, 4}, {4, 2}}},
          {"a = b", &word_symmetric, {{3, 3}, {2, 2}}},
          {"a = 1, b > 1 (list of classical distributions; section 2.3)",
           &word_convex,
           {{1, more}, {1, 2}, {1, 3}}},
          {"a > 1, b = 1 (list of classical distributions; section 2.3)",
           &word_concave,
           {{more, 1}, {2, 1}, {3, 1}}},
          {"a > 1, b > 1 (list of classical distributions)", &word_double_curved, {{3, 3}, {2, 4}, {4, 2}}}};
}

std::string shapes_told(const std::vector<Shape> &shapes) {
  std::string text;
  for (const Shape &s : shapes)
    text += fmt::format("{}({}, {})", text.empty() ? "" : ", ", to_decimal(s.a), to_decimal(s.b));
  return text.empty() ? "none" : text;
}

Statement shape_statement(const ShapeWord &row) {
  std::vector<Shape> of_curve, of_density;
  for (const Shape &shape : row.examples) {
    const std::vector<std::vector<Real>> all = differences_of(shape);
    if (is_true(*row.word, all, 0))
      of_curve.push_back(shape);
    if (is_true(*row.word, all, 1))
      of_density.push_back(shape);
  }
  const Shape &one = row.examples.front();
  return {fmt::format("The grading curve is {} for {}", row.word->word, row.shapes), "section 2.1",
          fmt::format(
              "of the shapes {} it is true of the volume density h' for {}, of the grading curve h for {}",
              shapes_told(row.examples), shapes_told(of_density), shapes_told(of_curve)),
          holds_in(of_curve.size() + of_density.size(), 2 * row.examples.size()),
          fmt::format("mdm generate --beta {},{} --dmin 1 --dmax 2 --table 12", to_decimal(one.a),
                      to_decimal(one.b))};
}

} // namespace

std::vector<Statement> shape_statements() {
  std::vector<Statement> all;
  for (const ShapeWord &row : shape_words())
    all.push_back(shape_statement(row));
  return all;
}

} // namespace mdm
