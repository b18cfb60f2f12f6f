#include "papers/model_statements.hpp"

#include "packing/apollonian.hpp"
#include "sets/inverse_model.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>

namespace mdm {
namespace {

constexpr unsigned model_told_digits = 4;
constexpr const char *models = "mdm study --paper voivret --only models --out DIR";

std::string as_told(const Real &y) {
  return rounded(y, model_told_digits);
}

std::string as_told(const Interval &i) {
  return as_told(real_in(i));
}

std::string as_told(const Shape &shape) {
  return fmt::format("({}, {})", to_decimal(shape.a), to_decimal(shape.b));
}

std::string listed_in_text(const std::vector<std::string> &parts) {
  std::string text;
  for (const std::string &part : parts)
    text += (text.empty() ? "" : "; ") + part;
  return text.empty() ? "none" : text;
}

std::string file_of(int figure) {
  return fmt::format("{} (figure{}.csv)", models, figure);
}

// Section 1.

Statement uniform_by_volume() {
  return {"f(d) d^2 = constant makes all size classes have the same volume", "section 1.2, Eq. 2",
          "true of discs; with f(d) d^2 = 1 spheres between 1 and 2 have (2^2 - 1^2) / 2 = 1.5 of the volume "
          "for 2.5 between 2 "
          "and 3: there f(d) d^3 is constant",
          Holds::partly, "mdm generate --beta 1,1 --dmin 1 --dmax 3 --dimension 3 --table 3"};
}

Statement inverse_partition() {
  const Rational least = 1, most = 3;
  std::size_t right = 0;
  constexpr unsigned cases = 10;
  for (unsigned i = 0; i < cases; ++i) {
    const Rational y = ratio(2 * i + 1, 2 * cases), d = most * least / (most + y * (least - most));
    right += most / (most - least) * (d - least) / d == y ? 1U : 0U;
  }
  return {"F_uv^-1(y) = d_max d_min / (d_max + y (d_min - d_max))", "Eq. 4",
          fmt::format("F_uv of Eq. 3 gives back y exactly for {} of {} y between the sizes 1 and 3", right,
                      cases),
          holds_in(right, cases),
          "mdm generate --beta 1,1 --dmin 1 --dmax 3 --dimension 2 --classes 1 --sizes --format csv"};
}

Statement apollonian_fills() {
  const ApollonianGasket gasket = ApollonianGasket::equal();
  std::vector<std::string> parts;
  std::vector<Interval> covered;
  for (const int most : {10, 100, 1000, 10000}) {
    covered.push_back(gasket.covered(gasket.census(most)));
    parts.push_back(fmt::format("{} with radii from 1/{}", as_told(covered.back()), most));
  }
  bool grows = true;
  for (std::size_t i = 1; i < covered.size(); ++i)
    grows = grows && covered[i - 1].hi < covered[i].lo;
  return {"The Apollonian packing tends to fill the space", "section 1.1, Figure 2",
          "covered of the outer circle: " + listed_in_text(parts) +
              "; that it grows, to above 0.99, was asked",
          grows && covered.back().lo > ratio(99, 100) ? Holds::yes : Holds::no,
          "mdm pack --apollonian equal --smallest 1/10000 --count-only"};
}

Statement apollonian_power_law() {
  const ApollonianCensus census = ApollonianGasket::equal().census(10000);
  std::vector<std::string> parts;
  std::uint64_t all = census.circles;
  Interval least(10), greatest(0);
  for (std::size_t j = 0; j < 4; ++j) {
    const std::uint64_t half = all - census.octaves.at(j);
    const Enclosure slope = enclose(apollonian_slope(all, half), 10);
    least = {std::min(least.lo, slope.lower()), std::min(least.hi, slope.upper())};
    greatest = {std::max(greatest.lo, slope.lower()), std::max(greatest.hi, slope.upper())};
    parts.push_back(as_told(Interval(slope.lower(), slope.upper())));
    all = half;
  }
  return {"Its size distribution is a power law and the structure is fractal", "section 1.1, Figure 2",
          fmt::format("slopes of log N over log (1 / radius) in the last four octaves up to 10000: {}; the "
                      "dimension is 1.30568...; "
                      "slopes within 0.02 of each other were asked",
                      listed_in_text(parts)),
          greatest.hi - least.lo < ratio(2, 100) ? Holds::yes : Holds::no,
          "mdm pack --apollonian equal --smallest 1/10000 --count-only"};
}

// Section 2.1.

Statement bidisperse_limit() {
  std::vector<std::string> parts;
  std::vector<Enclosure> between;
  for (const Rational &a : {ratio(1, 10), ratio(1, 100), ratio(1, 1000)}) {
    const BetaCurve curve(a, a, 1, 2);
    between.push_back(enclose(curve.passing(Real(ratio(19, 10))) - curve.passing(Real(ratio(11, 10))), 10));
    parts.push_back(fmt::format("{} for {}",
                                as_told(Interval(between.back().lower(), between.back().upper())),
                                as_told(Shape{a, a})));
  }
  const bool falls = between[1].upper() < between[0].lower() && between[2].upper() < between[1].lower();
  return {"a < 1, b < 1 tends to two sizes as a and b decrease", "section 2.1",
          "volume with 0.1 < d_r < 0.9: " + listed_in_text(parts) + "; a fall to below 0.01 was asked",
          falls && between[2].upper() < ratio(1, 100) ? Holds::yes : Holds::no,
          "mdm generate --beta 0.001,0.001 --dmin 1 --dmax 2 --table 11"};
}

Statement uniform_by_size() {
  // f is proportional to (d - d_min)^2 / d^D.
  const Rational most = 99, middle = 50;
  const auto density = [](const Rational &d, unsigned dimension) {
    return Rational(power(Rational(d - 1), 2) / power(d, dimension));
  };
  const Rational discs = density(middle, 2) / density(most, 2),
                 spheres = density(middle, 3) / density(most, 3);
  return {"a = 3, b = 1 is uniform by particle sizes", "section 2.1; section 2.3",
          fmt::format("f(d) is proportional to (d - d_min)^2 / d^D: of discs f in the middle is {} times f "
                      "at d_max for s = 0.98, "
                      "and 0 at d_min; it is constant in the limit of d_min = 0 alone; of spheres {} times",
                      as_told(Real(discs)), as_told(Real(spheres))),
          Holds::partly, "mdm generate --beta 3,1 --dmin 1 --span 0.98 --dimension 2 --table 10"};
}

Statement ratio_of_span() {
  const Rational r = (1 + ratio(98, 100)) / (1 - ratio(98, 100)), s = ratio(99, 101);
  return {"s = 0.98 corresponds to R = 100", "section 2.2",
          fmt::format("R = (1 + s) / (1 - s) = {}; R = 100 is s = 99/101 = {}", as_told(Real(r)),
                      rounded(Real(s), 6)),
          r == 100 ? Holds::yes : Holds::partly, "mdm generate --beta 1,3 --dmin 1 --span 0.98"};
}

/// The courses of C_u, or C_c, over the span: shape by shape, whether it rises all the way.
struct Course {
  Shape shape;
  bool rises = true, falls = true;
};

std::vector<Course> courses(const std::vector<CoefficientRow> &rows, Real CoefficientRow::*value) {
  std::vector<Course> all;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].span < rows[i - 1].span) {
      all.push_back({rows[i].shape});
      continue;
    }
    const Order order = compare(rows[i - 1].*value, rows[i].*value);
    all.back().rises = all.back().rises && order == Order::less;
    all.back().falls = all.back().falls && order == Order::greater;
  }
  return all;
}

Statement monotonic_uniformity(const ModelStudy &study) {
  const std::vector<Course> all = courses(study.coefficients, &CoefficientRow::c_u);
  const auto rising = static_cast<std::size_t>(
      std::count_if(all.begin(), all.end(), [](const Course &c) { return c.rises; }));
  return {"C_u is a monotonic function of s for all shapes", "section 2.1, Figure 4",
          fmt::format("it rises at all 49 spans for {} of {} shapes; in general C_u - 1 is w (x_60 - x_10) / "
                      "(1 + w x_10) with w = 2 s / "
                      "(1 - s), which grows with w",
                      rising, all.size()),
          holds_in(rising, all.size()), file_of(4)};
}

Statement complex_curvature(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::size_t turning = 0;
  for (const Course &c : courses(study.coefficients, &CoefficientRow::c_c)) {
    parts.push_back(as_told(c.shape) + (c.rises ? " rises" : c.falls ? " falls" : " turns"));
    turning += c.rises || c.falls ? 0U : 1U;
  }
  return {"C_c is a complex function of s, a and b", "section 2.1, Figure 4",
          listed_in_text(parts) + "; shapes that turn, or rise and fall, were asked",
          parts.empty() ? Holds::open
          : turning > 0 ? Holds::yes
                        : Holds::no,
          file_of(4)};
}

Statement determined_shape() {
  Statement s{"C_u and C_c determine the shape and the span", "section 2.1", "", Holds::open,
              "mdm generate --cu 6 --cc 1.2 --span 0.9,0.95"};
  std::vector<std::string> parts;
  std::size_t proved = 0;
  for (const Rational &span : {ratio(9, 10), ratio(95, 100)}) {
    const InverseShapes found = inverse_shapes({Rational(6), ratio(12, 10), span, {ratio(1, 10), 20}});
    for (const ShapeBox &box : found.boxes) {
      proved += box.holds_one ? 1U : 0U;
      parts.push_back(fmt::format("({}, {}) at s = {}", as_told(Interval((box.a.lo + box.a.hi) / 2)),
                                  as_told(Interval((box.b.lo + box.b.hi) / 2)), to_decimal(span)));
    }
  }
  s.found = "C_u = 6 and C_c = 1.2 are those of shapes near " + listed_in_text(parts) +
            ": two numbers do not determine three; at a given span the shapes are enclosed (Theorem 25)";
  s.holds = proved > 1 ? Holds::partly : Holds::open;
  return s;
}

// Section 2.2.

/// The rows of one shape and classing.
std::vector<const SetRow *> rows_of(const std::vector<SetRow> &rows, const Shape &shape, Classing classing) {
  std::vector<const SetRow *> some;
  for (const SetRow &row : rows)
    if (row.question.shape.a == shape.a && row.question.shape.b == shape.b &&
        row.question.classing == classing)
      some.push_back(&row);
  return some;
}

const Classing both_classings[] = {Classing::geometric, Classing::regular};

/// Calls for every shape and classing, with its rows and name.
template <class Take>
void each_line(const std::vector<SetRow> &rows, Take take) {
  for (const Classing classing : both_classings)
    for (const Shape &shape : compared_shapes())
      take(rows_of(rows, shape, classing), fmt::format("{} {}", as_told(shape), name(classing)));
}

Statement ten_classes(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::size_t good = 0, all = 0;
  each_line(study.classes, [&](const std::vector<const SetRow *> &rows, const std::string &who) {
    for (const SetRow *row : rows)
      if (row->question.classes == 10 && !row->c_r.empty()) {
        parts.push_back(fmt::format("{} for {}", as_told(row->mean()), who));
        ++all;
        good += row->mean().hi < ratio(5, 100) ? 1U : 0U;
      }
  });
  return {"Ten size classes give a good agreement with h", "section 2.2, Figure 5a",
          "C_r, mean of ten draws: " + listed_in_text(parts) + "; below 0.05 was asked", holds_in(good, all),
          file_of(5)};
}

Statement more_classes(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::size_t better = 0, all = 0;
  each_line(study.classes, [&](const std::vector<const SetRow *> &rows, const std::string &who) {
    const SetRow *first = nullptr, *last = nullptr;
    for (const SetRow *row : rows)
      if (!row->c_r.empty()) {
        first = first == nullptr ? row : first;
        last = row;
      }
    if (first == last)
      return;
    ++all;
    better += last->mean().hi < first->mean().lo ? 1U : 0U;
    parts.push_back(fmt::format("{}: {} with {} to {} with {}", who, as_told(first->mean()),
                                first->question.classes, as_told(last->mean()), last->question.classes));
  });
  return {"A large number of classes approximates the curve well", "section 2.2, Figure 5a",
          "C_r from the fewest to the most classes that were drawn: " + listed_in_text(parts),
          holds_in(better, all), file_of(5)};
}

Statement particles_over_classes(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::size_t right = 0, all = 0;
  each_line(study.classes, [&](const std::vector<const SetRow *> &rows, const std::string &who) {
    const SetRow *ten = nullptr, *last = nullptr, *first = nullptr;
    for (const SetRow *row : rows)
      if (row->counts.decided()) {
        first = first == nullptr ? row : first;
        ten = row->question.classes == 10 ? row : ten;
        last = row;
      }
    if (ten == nullptr)
      return;
    all += 2;
    right += first->counts.estimated().hi < first->question.wanted.at_least ? 1U : 0U;
    right += last->counts.particles() > 2 * ten->counts.particles() ? 1U : 0U;
    parts.push_back(fmt::format("{}: {}, {} and {}", who, to_string(first->counts.particles()),
                                to_string(ten->counts.particles()), to_string(last->counts.particles())));
  });
  return {"For few classes N_min decides, for many N increases strongly", "section 2.2, Figure 5b",
          "N with 1, 10 and 30 classes: " + listed_in_text(parts) +
              "; N' < N_min with 1, and twice the N of 10 with 30, were asked",
          holds_in(right, all), file_of(5)};
}

/// The greatest mean of C_r over the least.
std::optional<Interval> spread_of_quality(const std::vector<const SetRow *> &rows) {
  std::optional<Interval> least, greatest;
  for (const SetRow *row : rows)
    if (!row->c_r.empty()) {
      const Interval mean = row->mean();
      least = !least || mean.lo < least->lo ? mean : *least;
      greatest = !greatest || mean.hi > greatest->hi ? mean : *greatest;
    }
  return least ? std::optional(*greatest / *least) : std::nullopt;
}

Statement quality_over_class_sizes(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::vector<Interval> spreads;
  for (const Shape &shape : compared_shapes())
    if (const auto spread = spread_of_quality(rows_of(study.class_sizes, shape, Classing::geometric))) {
      spreads.push_back(*spread);
      parts.push_back(fmt::format("{} times for {}", as_told(*spread), as_told(shape)));
    }
  Statement s{"The impact of N_pc on C_r shows mainly for a = 1, b = 3", "section 2.2, Figure 6a",
              "greatest mean C_r over the least, geometric classes, N_pc from 1 to 200: " +
                  listed_in_text(parts),
              Holds::open, file_of(6)};
  if (spreads.size() == compared_shapes().size())
    s.holds = spreads[0].lo > spreads[1].hi && spreads[0].lo > spreads[2].hi ? Holds::yes : Holds::no;
  return s;
}

std::vector<const SetRow *> all_sets(const ModelStudy &study) {
  std::vector<const SetRow *> all;
  for (const std::vector<SetRow> *rows : {&study.classes, &study.class_sizes, &study.totals})
    for (const SetRow &row : *rows)
      if (row.counts.decided())
        all.push_back(&row);
  return all;
}

Statement scarcest_class(const ModelStudy &study) {
  std::size_t falling = 0, rising = 0, others = 0, right = 0;
  for (const SetRow *row : all_sets(study)) {
    std::vector<Integer> n;
    for (const IntegerBounds &one : row->counts.estimate)
      n.push_back(one.lo);
    if (n.size() < 2)
      continue;
    const Integer &wanted = row->question.wanted.min_per_class;
    if (std::is_sorted(n.rbegin(), n.rend())) {
      ++falling;
      right += n.back() == wanted ? 1U : 0U;
    } else if (std::is_sorted(n.begin(), n.end())) {
      ++rising;
      right += n.front() == wanted ? 1U : 0U;
    } else {
      ++others;
    }
  }
  return {
      "Where N_i decreases with the size the class of the largest has N_pc, where it increases that of "
      "the smallest",
      "section 2.2",
      fmt::format("true for {} of {} sets of Figures 5 to 7, {} with decreasing and {} with increasing N_i; "
                  "{} have neither",
                  right, falling + rising, falling, rising, others),
      holds_in(right, falling + rising), file_of(6)};
}

Statement least_in_class(const ModelStudy &study) {
  const std::vector<const SetRow *> all = all_sets(study);
  const auto right = static_cast<std::size_t>(std::count_if(all.begin(), all.end(), [](const SetRow *row) {
    return *std::min_element(row->counts.numbers.begin(), row->counts.numbers.end()) >=
           row->question.wanted.min_per_class;
  }));
  return {"The least populated class has at least N_pc particles", "section 1.2, Eq. 8",
          fmt::format("{} of {} sets of Figures 5 to 7", right, all.size()), holds_in(right, all.size()),
          file_of(5)};
}

Statement least_in_all(const ModelStudy &study) {
  std::size_t right = 0;
  Integer most_missing = 0;
  const std::vector<const SetRow *> all = all_sets(study);
  for (const SetRow *row : all) {
    const Integer missing = row->question.wanted.at_least - row->counts.particles();
    right += missing <= 0 ? 1U : 0U;
    most_missing = std::max(most_missing, missing);
  }
  return {"N_min is the lower bound of N", "section 2.2, Eq. 9",
          fmt::format("{} of {} sets have N_min and more; the floors of Eq. 9 leave up to {} too few", right,
                      all.size(), to_string(most_missing)),
          holds_in(right, all.size()), file_of(7)};
}

Statement quality_over_totals(const ModelStudy &study) {
  std::vector<std::string> parts;
  std::size_t weak = 0, all = 0;
  each_line(study.totals, [&](const std::vector<const SetRow *> &rows, const std::string &who) {
    if (const auto spread = spread_of_quality(rows)) {
      ++all;
      weak += spread->hi < ratio(3, 2) ? 1U : 0U;
      parts.push_back(fmt::format("{} times for {}", as_told(*spread), who));
    }
  });
  return {"N_min has a weak impact on C_r", "section 2.2, Figure 7a",
          "greatest mean C_r over the least, N_min from 100 to 200000: " + listed_in_text(parts) +
              "; below 1.5 was asked",
          holds_in(weak, all), file_of(7)};
}

Statement plateaus(const ModelStudy &study) {
  std::size_t right = 0, all = 0;
  for (const SetRow &row : study.totals)
    if (row.counts.decided()) {
      ++all;
      const Integer n = row.counts.particles(), estimated = row.counts.estimated().lo,
                    &wanted = row.question.wanted.at_least;
      right +=
          (estimated >= wanted ? n == estimated : n <= wanted && n > wanted - row.question.classes) ? 1U : 0U;
    }
  return {"N is a plateau while N_min is small, then N = N_min", "section 2.2, Figure 7b",
          fmt::format("{} of {} sets have N' where that is N_min or more, else N_min less fewer than N_c",
                      right, all),
          holds_in(right, all), file_of(7)};
}

// Section 2.3.

struct Map {
  Classing classing;
  Rational span;
  std::vector<const ShapeRow *> rows;

  std::string told() const { return fmt::format("s = {} {}", to_decimal(span), name(classing)); }
  bool has(const Shape &shape, unsigned power) const {
    const auto at = std::find_if(rows.begin(), rows.end(), [&](const ShapeRow *row) {
      return row->question.shape.a == shape.a && row->question.shape.b == shape.b;
    });
    return at != rows.end() && (*at)->particles <= power_of_ten(power);
  }
  std::size_t accessible(unsigned power) const {
    return static_cast<std::size_t>(std::count_if(rows.begin(), rows.end(), [&](const ShapeRow *row) {
      return row->particles <= power_of_ten(power);
    }));
  }
};

std::vector<Map> maps_of(const ModelStudy &study) {
  std::vector<Map> maps;
  for (const ShapeRow &row : study.maps) {
    const auto at = std::find_if(maps.begin(), maps.end(), [&](const Map &m) {
      return m.classing == row.question.classing && m.span == row.question.span;
    });
    Map &map = at != maps.end() ? *at : maps.emplace_back(Map{row.question.classing, row.question.span, {}});
    map.rows.push_back(&row);
  }
  return maps;
}

/// A statement about each map: what it shows, and how many are as the paper says.
Statement map_statement(const std::vector<Map> &maps, const char *statement, const char *asked,
                        const std::function<std::pair<std::string, bool>(const Map &)> &look) {
  std::vector<std::string> parts;
  std::size_t right = 0;
  for (const Map &map : maps) {
    const auto [text, holds] = look(map);
    parts.push_back(map.told() + ": " + text);
    right += holds ? 1U : 0U;
  }
  return {statement, "section 2.3, Figure 8", listed_in_text(parts) + "; " + asked,
          holds_in(right, maps.size()), file_of(8)};
}

/// The largest t of the grid for which the shape is accessible with 10^6 particles.
std::optional<Rational> limit(const Map &map, const std::function<Shape(const Rational &)> &shape) {
  std::optional<Rational> largest;
  for (const ShapeRow *row : map.rows)
    if (map.has(shape(row->question.shape.a), 6) && (!largest || row->question.shape.a > *largest))
      largest = row->question.shape.a;
  return largest;
}

Statement limit_statement(const std::vector<Map> &maps, const char *statement, const char *asked,
                          const std::function<Shape(const Rational &)> &shape,
                          const std::function<bool(const Rational &)> &is_right) {
  return map_statement(maps, statement, asked, [&](const Map &map) {
    const std::optional<Rational> largest = limit(map, shape);
    return std::pair(largest ? to_decimal(*largest) : "none", largest && is_right(*largest));
  });
}

std::vector<Statement> map_statements(const std::vector<Map> &maps) {
  return {map_statement(maps, "The accessible domain expands slowly with N",
                        "less than twice the shapes for ten times N was asked",
                        [](const Map &map) {
                          const std::size_t four = map.accessible(4), five = map.accessible(5),
                                            six = map.accessible(6);
                          return std::pair(fmt::format("{}, {} and {} of {} shapes with 10^4, 10^5 and 10^6",
                                                       four, five, six, map.rows.size()),
                                           five < 2 * four && six < 2 * five);
                        }),
          limit_statement(
              maps, "Below 10^6 particles values larger than a = b = 10 cannot be realized",
              "the largest a = b, of steps of 1/2 up to 12, was asked",
              [](const Rational &t) {
                return Shape{t, t};
              },
              [](const Rational &t) { return t <= 10; }),
          limit_statement(
              maps, "For a = 1 the limit of b is about 4", "the largest b with 10^6; within 1 of 4 was asked",
              [](const Rational &t) {
                return Shape{1, t};
              },
              [](const Rational &t) { return abs(Rational(t - 4)) <= 1; }),
          limit_statement(
              maps, "For b = 1 the limit of a is about 7", "the largest a with 10^6; within 1 of 7 was asked",
              [](const Rational &t) {
                return Shape{t, 1};
              },
              [](const Rational &t) { return abs(Rational(t - 7)) <= 1; }),
          map_statement(maps, "The domain is not symmetric about a = b, and smaller for a < b",
                        "shapes with 10^6 particles; fewer with a < b were asked",
                        [](const Map &map) {
                          std::size_t below = 0, above = 0;
                          for (const ShapeRow *row : map.rows)
                            if (row->particles <= power_of_ten(6)) {
                              below += row->question.shape.a < row->question.shape.b ? 1U : 0U;
                              above += row->question.shape.a > row->question.shape.b ? 1U : 0U;
                            }
                          return std::pair(fmt::format("{} with a < b, {} with a > b", below, above),
                                           below < above);
                        }),
          map_statement(maps, "(3, 1) and (1, 1) are inside the domain", "10^6 particles were asked",
                        [](const Map &map) {
                          const bool coarse = map.has({3, 1}, 6), uniform = map.has({1, 1}, 6);
                          return std::pair(fmt::format("(3, 1) is {}, (1, 1) {}",
                                                       coarse ? "inside" : "outside",
                                                       uniform ? "inside" : "outside"),
                                           coarse && uniform);
                        })};
}

// Section 2.4.

Real square_root_of(int n) {
  return pow(Real(n), ratio(1, 2));
}

/// The curvature of the circle in the gap of three that touch each other (Descartes).
Real in_gap(const Real &k1, const Real &k2, const Real &k3) {
  return k1 + k2 + k3 + Real(2) * pow(k1 * k2 + k2 * k3 + k3 * k1, ratio(1, 2));
}

bool is_printed(const Real &y, const Rational &printed, const Rational &half_unit) {
  return compare(y, Real(Rational(printed - half_unit))) != Order::less &&
         compare(y, Real(Rational(printed + half_unit))) == Order::less;
}

Statement insertion_span() {
  const Real r = Real(1) + square_root_of(2), s = (r - Real(1)) / (r + Real(1));
  return {"The smallest fit into the pores of a square lattice precisely at s = 0.41", "section 2.4",
          fmt::format("the pore of four equal discs takes the radius sqrt 2 - 1 = {}, that is R = {} and s = "
                      "(R - 1) / (R + 1) = sqrt 2 - 1 "
                      "as well",
                      rounded(s, 6), rounded(r, 6)),
          is_printed(s, ratio(41, 100), ratio(5, 1000)) ? Holds::yes : Holds::no, models};
}

Statement insertion_ratios(const char *statement, const Real &first, const Rational &printed,
                           const Rational &half_unit) {
  const Real second = in_gap(Real(1), Real(1), first), squared = first * first;
  const bool first_holds = is_printed(first, printed, half_unit);
  const bool second_holds = is_printed(second / squared, 1, ratio(1, 100));
  return {statement, "section 2.4",
          fmt::format("n = 1: {}; n = 2: the gap between two lattice discs and the inserted one takes R = {} "
                      "(Descartes), where the square "
                      "is {}",
                      rounded(first, 5), rounded(second, 5), rounded(squared, 5)),
          holds_in((first_holds ? 1U : 0U) + (second_holds ? 1U : 0U), 2),
          "mdm pack --apollonian equal --smallest 1/100 --count-only"};
}

} // namespace

std::vector<Statement> model_statements(const ModelStudy &study) {
  std::vector<Statement> all = {uniform_by_volume(), inverse_partition(), apollonian_fills(),
                                apollonian_power_law()};
  const auto add = [&all](std::vector<Statement> more) {
    for (Statement &s : more)
      all.push_back(std::move(s));
  };
  add(shape_statements());
  add({bidisperse_limit(), uniform_by_size(), monotonic_uniformity(study), complex_curvature(study),
       determined_shape(), ratio_of_span(), least_in_class(study), ten_classes(study), more_classes(study),
       particles_over_classes(study), quality_over_class_sizes(study), scarcest_class(study),
       least_in_all(study), quality_over_totals(study), plateaus(study)});
  add(map_statements(maps_of(study)));
  add({insertion_span(),
       insertion_ratios("The n-th generation in a square lattice takes a ratio above 2.4^n",
                        Real(1) + square_root_of(2), ratio(24, 10), ratio(5, 100)),
       insertion_ratios("The n-th generation in a triangular lattice takes a ratio above 6.46^n",
                        Real(3) + Real(2) * square_root_of(3), ratio(646, 100), ratio(5, 1000))});
  return all;
}

} // namespace mdm
