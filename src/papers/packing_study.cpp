#include "papers/packing_study.hpp"

#include "packing/lattice.hpp"
#include "packing/packing_writer.hpp"
#include "packing/set_discs.hpp"
#include "sets/set_sizes.hpp"
#include "text/option_name.hpp"
#include "text/versions.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

namespace mdm {
namespace {

constexpr unsigned classes_of_paper = 10;
constexpr unsigned size_digits = 15;
constexpr unsigned fraction_digits = 15;

struct Counted {
  std::vector<SizeClass> classes;
  ClassCounts counts;
};

Counted counted(const DepositQuestion &q, const PackingTerms &terms) {
  const BetaCurve curve = spanned_curve(q.shape, q.span);
  Counted c{size_classes(curve, q.classing, classes_of_paper), {}};
  c.counts = class_counts(c.classes, curve, {10, terms.at_least, 2});
  return c;
}

DepositFacts facts(const Packing &p, const std::string &what) {
  const PackingTexture t = packing_texture(p);
  if (!t.fraction)
    throw InputError(what + ": the discs are too few for a packing fraction: raise " + option("at-least"));
  DepositFacts f;
  f.discs = p.discs.size();
  const Enclosure fraction = enclose(*t.fraction, fraction_digits);
  f.fraction = {fraction.lower(), fraction.upper()};
  f.contacts = t.contacts.pairs.size();
  for (const PackedDisc &d : p.discs)
    f.outer_supports += (d.left < 0 ? 1U : 0U) + (d.right < 0 ? 1U : 0U);
  f.coordination = t.coordination;
  f.cells = t.cells;
  return f;
}

} // namespace

std::string PackingTerms::text() const {
  return fmt::format("mdm {}, N_c = {}, N_pc = 10, N_min = {}", versions().front().second, classes_of_paper,
                     to_string(at_least));
}

std::string DepositQuestion::key() const {
  return fmt::format("a = {}, b = {}, {}, s = {}, {}, seed {}", to_decimal(shape.a), to_decimal(shape.b),
                     name(classing), to_decimal(span), name(rule), seed);
}

Rational width_factor(std::uint64_t seed) {
  constexpr unsigned widths = 9, parts = 20;
  const int i = static_cast<int>((seed + widths - 1) % widths);
  return 1 + ratio(i % 2 == 1 ? (i + 1) / 2 : -i / 2, parts);
}

std::optional<Integer> disc_count(const DepositQuestion &question, const PackingTerms &terms) {
  const ClassCounts counts = counted(question, terms).counts;
  return counts.decided() ? std::optional(counts.particles()) : std::nullopt;
}

DiscSizes drawn_discs(const DepositQuestion &question, const PackingTerms &terms) {
  const Counted c = counted(question, terms);
  return set_discs(drawn_particles(c.classes, c.counts.numbers, 2, size_digits, Draws::random(question.seed)),
                   c.classes.size(), "");
}

Packing deposited(const DepositQuestion &question, const PackingTerms &terms) {
  const DiscSizes discs = drawn_discs(question, terms);
  DepositOptions options;
  options.rule = question.rule;
  options.seed = question.seed;
  if (const Rational factor = width_factor(question.seed); factor != 1)
    options.width = Rational(factor * packing::square_width(discs));
  try {
    return deposit(discs, options);
  } catch (const InputError &e) {
    throw InputError(question.key() + ": " + e.what());
  }
}

DepositFacts deposit_facts(const DepositQuestion &question, const PackingTerms &terms) {
  return facts(deposited(question, terms), question.key());
}

DepositFacts equal_disc_facts(const PackingTerms &terms) {
  DiscSizes discs;
  discs.sizes.assign(static_cast<std::size_t>(terms.at_least), {1, 0});
  DepositOptions options;
  options.floor = FloorRule::left;
  // The gaps between discs of one row, some 10^-12 of a diameter each, have room in this.
  options.width = Rational(floor_root(terms.at_least, 2)) + ratio(1, 100000000);
  return facts(deposit(discs, options), "equal discs");
}

Interval PackingPoint::mean() const {
  Interval sum(Rational(0));
  for (const DepositFacts &d : deposits)
    sum = sum + d.fraction;
  const Rational n(deposits.size());
  return {Rational(sum.lo / n), Rational(sum.hi / n)};
}

Interval PackingPoint::scatter() const {
  Interval least = deposits.front().fraction, greatest = least;
  for (const DepositFacts &d : deposits) {
    least = {std::min(least.lo, d.fraction.lo), std::min(least.hi, d.fraction.hi)};
    greatest = {std::max(greatest.lo, d.fraction.lo), std::max(greatest.hi, d.fraction.hi)};
  }
  return {std::max(Rational(0), Rational(greatest.lo - least.hi)), Rational(greatest.hi - least.lo)};
}

Rational PackingPoint::coordination() const {
  Integer contacts = 0, n = 0;
  for (const DepositFacts &d : deposits) {
    contacts += d.contacts;
    n += d.discs;
  }
  return ratio(2 * contacts, n);
}

Rational PackingPoint::touching(std::uint32_t contacts) const {
  Integer some = 0, n = 0;
  for (const DepositFacts &d : deposits) {
    const auto found = d.coordination.find(contacts);
    some += found == d.coordination.end() ? 0 : found->second;
    n += d.discs;
  }
  return ratio(some, n);
}

CellCounts PackingPoint::cells() const {
  CellCounts sum;
  for (const DepositFacts &d : deposits) {
    sum.triangles += d.cells.triangles;
    sum.quadrangles += d.cells.quadrangles;
    sum.pentagons += d.cells.pentagons;
    sum.larger += d.cells.larger;
  }
  return sum;
}

std::vector<Shape> packed_shapes() {
  return {{1, 1}, {1, 3}, {2, 4}, {3, 1}, {4, 2}, {4, 4}};
}

std::vector<Rational> packed_spans() {
  std::vector<Rational> spans;
  for (const int percent : {2, 5, 10, 20, 30, 40, 50, 60, 70, 80, 90, 97})
    spans.push_back(ratio(percent, 100));
  return spans;
}

std::vector<PackingPoint> figure9_points(const std::vector<Rational> &spans, const PackingTerms &terms) {
  std::vector<PackingPoint> points;
  for (const Classing classing : {Classing::geometric, Classing::regular})
    for (const Shape &shape : packed_shapes())
      for (const Rational &span : spans)
        points.push_back({shape, classing, span, disc_count({shape, classing, span}, terms), {}});
  return points;
}

} // namespace mdm
