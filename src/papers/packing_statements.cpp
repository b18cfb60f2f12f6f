#include "papers/packing_statements.hpp"

#include <mdm/number/decimal.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <set>

namespace mdm {
namespace {

constexpr unsigned shown_digits = 4;
constexpr const char *packings = "mdm study --paper voivret --only packings --out DIR";

const Rational &tenth() {
  static const Rational r = ratio(1, 10);
  return r;
}

const Rational &four_tenths() {
  static const Rational r = ratio(4, 10);
  return r;
}

/// A fraction to so many digits as people look at.
std::string shown(const Rational &r) {
  return r < 0 ? "-" + shown(Rational(-r)) : rounded(Real(r), shown_digits);
}

std::string shown(const Interval &i) {
  return shown(Rational((i.lo + i.hi) / 2));
}

std::string percent(const Integer &some, const Integer &all) {
  return rounded(Real(ratio(100 * some, all)), 3) + " %";
}

std::string shown(const Shape &shape) {
  return fmt::format("({}, {})", to_decimal(shape.a), to_decimal(shape.b));
}

std::string span_text(const Rational &span) {
  return "s = " + to_decimal(span);
}

const char *shown(Classing classing) {
  return classing == Classing::regular ? "regular classes" : "geometric classes";
}

bool is_uniform(const Shape &shape) {
  return shape.a == 1 && shape.b == 1;
}

std::string join(const std::vector<std::string> &parts) {
  std::string text;
  for (const std::string &part : parts)
    text += (text.empty() ? "" : "; ") + part;
  return text;
}

/// The points of a study, by what the statements are about.
class Findings {
public:
  explicit Findings(const PackingStudy &study) : study_(study) {
    for (const PackingPoint &p : study.points)
      spans_.insert(p.span);
  }

  const PackingStudy &study() const { return study_; }
  const std::set<Rational> &spans() const { return spans_; }

  /// Null where it was left out.
  const PackingPoint *at(const Shape &shape, Classing classing, const Rational &span) const {
    const auto found = std::find_if(study_.points.begin(), study_.points.end(), [&](const PackingPoint &p) {
      return p.shape.a == shape.a && p.shape.b == shape.b && p.classing == classing && p.span == span &&
             !p.deposits.empty();
    });
    return found == study_.points.end() ? nullptr : &*found;
  }

  /// The points of a shape with deposits, by span.
  std::vector<const PackingPoint *> of(const Shape &shape, Classing classing, const Rational &from,
                                       const Rational &to) const {
    std::vector<const PackingPoint *> all;
    for (const Rational &span : spans_)
      if (const PackingPoint *p = span >= from && span <= to ? at(shape, classing, span) : nullptr)
        all.push_back(p);
    return all;
  }

private:
  const PackingStudy &study_;
  std::set<Rational> spans_;
};

using Points = std::vector<const PackingPoint *>;
constexpr Classing geometric = Classing::geometric;

/// Certainly larger.
bool is_above(const Interval &a, const Interval &b) {
  return a.lo > b.hi;
}

/// `0.8229 (s = 0.05)`, for each point.
template <class Value>
std::string listed(const Points &points, Value value) {
  std::vector<std::string> parts;
  for (const PackingPoint *p : points)
    parts.push_back(shown(value(*p)) + " (" + span_text(p->span) + ")");
  return join(parts);
}

Interval mean_of(const PackingPoint &p) {
  return p.mean();
}

Statement coordination_number(const Findings &f) {
  Statement s{"At s < 0.1 the coordination number is about 4", "section 2.4", "", Holds::open, packings};
  const Points points = f.of({1, 1}, geometric, 0, tenth());
  std::size_t near = 0;
  for (const PackingPoint *p : points)
    near += abs(Rational(p->coordination() - 4)) < tenth() ? 1U : 0U;
  s.found = "(1, 1): " + listed(points, [](const PackingPoint &p) { return p.coordination(); }) +
            "; each is 4 - 2 (supports by the floor) / N, as every disc has two supports; within 0.1 of 4 "
            "was asked";
  s.holds = holds_in(near, points.size());
  return s;
}

Statement square_lattice(const Findings &f) {
  Statement s{"At s = 0.02 a globally square lattice with local triangles and dislocations",
              "section 2.4, Figure 10", "", Holds::open, packings};
  const Points points = f.of({1, 1}, geometric, 0, tenth());
  if (points.empty())
    return s;
  const CellCounts cells = points.front()->cells();
  const Integer all = cells.total();
  s.found = fmt::format(
      "{}, (1, 1): {} of the cells have 4 corners, {} 3, {} 5, {} more; more than 3 of 4 cells with "
      "4 corners was asked",
      span_text(points.front()->span), percent(cells.quadrangles, all), percent(cells.triangles, all),
      percent(cells.pentagons, all), percent(cells.larger, all));
  s.holds = 4 * Integer(cells.quadrangles) > 3 * all && cells.triangles > 0 ? Holds::yes : Holds::no;
  return s;
}

Statement dense_at_low_span(const Findings &f) {
  Statement s{"At s < 0.1 the packing fraction is above 0.82", "section 2.4", "", Holds::open, packings};
  const PackingPoint *least = nullptr;
  std::size_t above = 0, all = 0;
  for (const PackingPoint &p : f.study().points)
    if (p.span < tenth() && !p.deposits.empty()) {
      ++all;
      above += is_above(p.mean(), Interval(ratio(82, 100))) ? 1U : 0U;
      if (least == nullptr || is_above(least->mean(), p.mean()))
        least = &p;
    }
  if (least != nullptr)
    s.found = fmt::format(
        "{} of {} means are; the smallest is {}, of {} at {}, {}, whose deposits in boxes of several "
        "widths differ by {}",
        above, all, shown(least->mean()), shown(least->shape), span_text(least->span), shown(least->classing),
        shown(least->scatter()));
  s.holds = holds_in(above, all);
  return s;
}

Statement declining_at_low_span(const Findings &f) {
  Statement s{"The packing fraction declines up to s = 0.1", "section 2.4", "", Holds::open, packings};
  std::vector<std::string> parts;
  std::size_t falling = 0, all = 0;
  for (const Shape &shape : packed_shapes()) {
    const Points points = f.of(shape, geometric, 0, tenth());
    if (points.size() < 2)
      continue;
    ++all;
    falling += is_above(points.front()->mean(), points.back()->mean()) ? 1U : 0U;
    parts.push_back(shown(shape) + ": " + listed(points, mean_of));
  }
  s.found = join(parts);
  s.holds = holds_in(falling, all);
  return s;
}

Statement equal_discs(const Findings &f) {
  const DepositFacts &d = f.study().equal;
  const Rational mean = mean_coordination(d.coordination);
  const Rational error = (d.fraction.lo + d.fraction.hi) / 2 - ratio(906, 1000);
  return {
      "Strictly equal discs pack in triangular cells, fraction 0.906", "section 2.4",
      fmt::format("{} with the floor filled from its left end, {} contacts a disc; within 0.001 was asked",
                  shown(d.fraction), shown(mean)),
      abs(error) <= ratio(1, 1000) ? Holds::yes : Holds::no, packings};
}

Statement random_close_packing(const Findings &f) {
  Statement s{"A small dispersion leads to a random close packing with a fraction close to 0.81",
              "section 2.4", "", Holds::open, packings};
  const Points points = f.of({1, 1}, geometric, tenth(), 1);
  if (points.empty())
    return s;
  const PackingPoint &p = *points.front();
  s.found = fmt::format("(1, 1), {}: {} by the rule of the paper", span_text(p.span), shown(p.mean()));
  for (const PackingPoint &d : f.study().dropped)
    if (d.span == p.span && !d.deposits.empty())
      s.found += fmt::format(", {} where discs drop in random columns and roll", shown(d.mean()));
  s.found += "; within 0.005 of 0.81 by the rule of the paper was asked";
  s.holds = is_above(Interval(ratio(815, 1000)), p.mean()) ? Holds::yes : Holds::no;
  return s;
}

/// First and last point in a range of spans.
std::optional<std::pair<const PackingPoint *, const PackingPoint *>> ends(const Points &points) {
  if (points.size() < 2)
    return std::nullopt;
  return std::pair(points.front(), points.back());
}

Interval slope(const PackingPoint &from, const PackingPoint &to) {
  const Interval rise = to.mean() - from.mean();
  const Rational width = to.span - from.span;
  return {Rational(rise.lo / width), Rational(rise.hi / width)};
}

Statement slow_rise(const Findings &f) {
  Statement s{"It rises slowly for 0.1 < s < 0.4", "section 2.4", "", Holds::open, packings};
  std::vector<std::string> parts;
  std::size_t rising = 0;
  for (const Shape &shape : packed_shapes())
    if (const auto range = ends(f.of(shape, geometric, tenth(), four_tenths()))) {
      const auto &[from, to] = *range;
      rising += is_above(to->mean(), from->mean()) ? 1U : 0U;
      parts.push_back(fmt::format("{}: {} to {}", shown(shape), shown(from->mean()), shown(to->mean())));
    }
  s.found = join(parts);
  s.holds = holds_in(rising, parts.size());
  return s;
}

Statement weak_shape(const Findings &f) {
  Statement s{"Apart from (1, 1) the shape matters little for 0.1 < s < 0.4", "section 2.4", "", Holds::open,
              packings};
  std::vector<std::string> parts;
  std::size_t near = 0;
  for (const Rational &span : f.spans()) {
    if (span < tenth() || span > four_tenths())
      continue;
    std::optional<Interval> least, greatest;
    for (const Shape &shape : packed_shapes())
      if (const PackingPoint *p = is_uniform(shape) ? nullptr : f.at(shape, geometric, span)) {
        const Interval mean = p->mean();
        least = !least || is_above(*least, mean) ? mean : *least;
        greatest = !greatest || is_above(mean, *greatest) ? mean : *greatest;
      }
    if (!least)
      continue;
    near += is_above(Interval(ratio(5, 1000)), *greatest - *least) ? 1U : 0U;
    parts.push_back(fmt::format("{} to {} ({})", shown(*least), shown(*greatest), span_text(span)));
  }
  s.found = "the five others: " + join(parts) + "; within 0.005 was asked";
  s.holds = holds_in(near, parts.size());
  return s;
}

Statement strong_rise(const Findings &f) {
  Statement s{"It rises strongly beyond s = 0.4", "section 2.4", "", Holds::open, packings};
  std::vector<std::string> parts;
  std::size_t steeper = 0;
  for (const Shape &shape : packed_shapes()) {
    const auto before = ends(f.of(shape, geometric, tenth(), four_tenths())),
               after = ends(f.of(shape, geometric, four_tenths(), 1));
    if (!before || !after)
      continue;
    const Interval slow = slope(*before->first, *before->second), fast = slope(*after->first, *after->second);
    steeper += is_above(fast, slow) ? 1U : 0U;
    parts.push_back(fmt::format("{}: {} to {} at {}, {} times as steep as before", shown(shape),
                                shown(after->first->mean()), shown(after->second->mean()),
                                span_text(after->second->span),
                                slow.lo > 0 ? shown(Rational(fast.lo / slow.hi)) : "many"));
  }
  s.found = join(parts);
  s.holds = holds_in(steeper, parts.size());
  return s;
}

/// The spans at which another shape than (1, 1) has the largest mean.
std::vector<std::string> exceptions(const Findings &f, Classing classing, std::size_t &compared) {
  std::vector<std::string> spans;
  for (const Rational &span : f.spans()) {
    const PackingPoint *uniform = f.at({1, 1}, classing, span);
    if (uniform == nullptr)
      continue;
    ++compared;
    for (const Shape &shape : packed_shapes())
      if (const PackingPoint *p = is_uniform(shape) ? nullptr : f.at(shape, classing, span))
        if (!is_above(uniform->mean(), p->mean())) {
          spans.push_back(span_text(span));
          break;
        }
  }
  return spans;
}

Statement uniform_is_best(const Findings &f) {
  Statement s{"(1, 1), uniform by volume, has the largest packing fraction at all s", "section 2.4", "",
              Holds::open, packings};
  std::vector<std::string> parts;
  std::size_t all = 0, other = 0;
  for (const Classing classing : {geometric, Classing::regular}) {
    const std::vector<std::string> spans = exceptions(f, classing, all);
    other += spans.size();
    std::string list;
    for (const std::string &span : spans)
      list += (list.empty() ? "" : ", ") + span;
    parts.push_back(
        fmt::format("{}: {}", shown(classing), spans.empty() ? "at all spans" : "at all spans but " + list));
  }
  s.found = join(parts);
  s.holds = holds_in(all - other, all);
  return s;
}

Statement fines_rise_faster(const Findings &f) {
  Statement s{
      "Beyond s = 0.4 shapes with many small discs, (1, 3) and (2, 4), rise faster than (3, 1) and (4, 2)",
      "section 2.4", "", Holds::open, packings};
  std::vector<std::string> parts;
  std::size_t faster = 0;
  for (const Rational &span : f.spans()) {
    if (span <= four_tenths())
      continue;
    const auto rise = [&](const Shape &shape) -> std::optional<Interval> {
      const PackingPoint *from = f.at(shape, geometric, four_tenths()), *to = f.at(shape, geometric, span);
      return from != nullptr && to != nullptr ? std::optional(to->mean() - from->mean()) : std::nullopt;
    };
    const auto fine1 = rise({1, 3}), fine2 = rise({2, 4}), coarse1 = rise({3, 1}), coarse2 = rise({4, 2});
    if (!fine1 || !fine2 || !coarse1 || !coarse2)
      continue;
    const bool holds = is_above(*fine1, *coarse1) && is_above(*fine1, *coarse2) &&
                       is_above(*fine2, *coarse1) && is_above(*fine2, *coarse2);
    faster += holds ? 1U : 0U;
    parts.push_back(fmt::format("{}: {} and {} against {} and {}", span_text(span), shown(*fine1),
                                shown(*fine2), shown(*coarse1), shown(*coarse2)));
  }
  s.found = "rise from s = 0.4 with geometric classes: " + join(parts);
  s.holds = holds_in(faster, parts.size());
  return s;
}

Statement inaccessible_shapes(const Findings &f) {
  Statement s{"Some shapes are not accessible with N_max particles at large s", "section 2.4", "",
              Holds::open, packings};
  std::vector<std::string> parts;
  for (const Classing classing : {geometric, Classing::regular})
    for (const Shape &shape : packed_shapes()) {
      const Points points = f.of(shape, classing, 0, 1);
      if (points.size() < f.spans().size())
        parts.push_back(
            fmt::format("{}, {}: {}", shown(shape), shown(classing),
                        points.empty() ? "at none of the spans" : "up to " + span_text(points.back()->span)));
    }
  s.found = (parts.empty() ? "all are accessible" : join(parts)) +
            "; N_max = " + to_string(f.study().terms.at_most);
  s.holds = parts.empty() ? Holds::no : Holds::yes;
  return s;
}

Statement four_contacts_fall(const Findings &f) {
  Statement s{"With s discs with four contacts become fewer, those with three and with five more",
              "abstract of Phys. Rev. E 76, 021301 (2007)", "", Holds::open, packings};
  const Points points = f.of({1, 1}, geometric, 0, four_tenths());
  if (points.size() < 2)
    return s;
  const PackingPoint &first = *points.front(), &last = *points.back();
  std::vector<std::string> parts;
  for (const std::uint32_t n : {3U, 4U, 5U})
    parts.push_back(fmt::format("{} contacts: {} to {} of the discs", n, shown(first.touching(n)),
                                shown(last.touching(n))));
  s.found = fmt::format("(1, 1), {} to {}: {}", span_text(first.span), span_text(last.span), join(parts));
  s.holds = holds_in((last.touching(3) > first.touching(3) ? 1U : 0U) +
                         (last.touching(4) < first.touching(4) ? 1U : 0U) +
                         (last.touching(5) > first.touching(5) ? 1U : 0U),
                     3);
  return s;
}

} // namespace

std::vector<Statement> packing_statements(const PackingStudy &study) {
  const Findings f(study);
  return {coordination_number(f), square_lattice(f),       dense_at_low_span(f), declining_at_low_span(f),
          equal_discs(f),         random_close_packing(f), slow_rise(f),         weak_shape(f),
          strong_rise(f),         uniform_is_best(f),      fines_rise_faster(f), inaccessible_shapes(f),
          four_contacts_fall(f)};
}

} // namespace mdm
