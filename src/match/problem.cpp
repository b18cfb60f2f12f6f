// The integer problem of an exact match (proofs/README.md, Theorem 1). What comes in are a gradation, a
// mass law x^(a/b) and floors; what goes out are integers f_j, F_j, m_j so that q particles of class j hold
// its mass at the scale s if and only if q^p f_j < S m_j <= q^p F_j for S = s^p: all are to the power p = b
// d, where openings to the power d are rational, so that nothing is irrational.
//
// Common denominators are cleared here, once, and what is common to all f and F, or to all m, is taken out.
// Searches then compare products of integers and never take a greatest common divisor. Scales that go in
// and come out are in units (scale_unit) that this leaves behind. A start of the scales becomes floors
// (Theorem 6).

#include "match/problem.hpp"

#include "number/common_denominator.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

std::size_t bits_of(mpz_srcptr n) {
  return mpz_sizeinbase(n, 2);
}

/// No fewer than the bits, quickly.
std::size_t bits_of_words(mpz_srcptr n) {
  return 64 * mpz_size(n);
}

/// The most bits of a number of the problem; of an opening the d-th part of those of its d-th power.
template <class Bits>
std::size_t longest(const Gradation &g, const std::vector<Rational> &openings, const Integer &min_per_class,
                    Bits bits) {
  std::size_t most = bits(min_per_class.backend().data());
  const auto add = [&](const std::vector<Rational> &column, std::size_t count, unsigned root) {
    for (std::size_t j = 0; j < count; ++j) {
      const std::size_t longer = std::max(bits(mpq_numref(column[j].backend().data())),
                                          bits(mpq_denref(column[j].backend().data())));
      most = std::max(most, root == 1 ? longer : (longer + root - 1) / root);
    }
  };
  add(openings, g.classes() + 1, g.root());
  add(g.masses(), g.classes(), 1);
  add(g.factors(), g.has_factors() ? g.classes() : 0, 1);
  return most;
}

void check_powers(const Gradation &g, const std::vector<Rational> &openings, const MassLaw &law,
                  const Integer &min_per_class) {
  const std::size_t degree = std::size_t{std::max(law.a, law.b)} * g.root();
  if (longest(g, openings, min_per_class, bits_of_words) * degree <= max_power_bits ||
      longest(g, openings, min_per_class, bits_of) * degree <= max_power_bits)
    return;
  if (g.root() > 1)
    throw InputError("the openings 2^-phi mm are roots of degree " + std::to_string(g.root()) +
                     " of fractions, whose powers are too long with numbers this long: " +
                     std::string(g.fractions_remedy()));
  throw InputError((law.is_power() ? "the exponent " + law.exponent() + " is too large"
                                   : std::string("the values of the mass law are too long")) +
                   " for numbers this long: round one of them");
}

/// sum m_j / c_j.
Rational weight_of(const Gradation &g, const CommonDenominator &masses) {
  if (!g.has_factors())
    return ratio(total(masses.numerators), masses.denominator);
  std::vector<Rational> weights;
  for (std::size_t j = 0; j < g.classes(); ++j)
    weights.push_back(g.mass(j) / g.factor(j));
  return sum(weights);
}

/// The extreme of q^p end / mass over the classes, `end` being f or F: the least, or the greatest. Compared
/// as fractions, reduced only at the end.
Rational extreme_scale(const std::vector<ProblemClass> &classes, const std::vector<Integer> &q, unsigned p,
                       Integer ProblemClass::*end, bool greatest) {
  Integer best, other, left, right;
  const auto multiply = [](Integer &product, const Integer &x, const Integer &y) {
    mpz_mul(product.backend().data(), x.backend().data(), y.backend().data());
  };
  const auto end_of = [&](std::size_t j, Integer &product) {
    multiply(product, p == 1 ? q[j] : power(q[j], p), classes[j].*end);
  };
  end_of(0, best);
  const Integer *best_mass = &classes[0].mass;
  for (std::size_t j = 1; j < q.size(); ++j) {
    end_of(j, other);
    multiply(left, other, *best_mass);
    multiply(right, best, classes[j].mass);
    if ((left < right) == greatest)
      continue;
    best.swap(other);
    best_mass = &classes[j].mass;
  }
  return ratio(best, *best_mass);
}

} // namespace

std::vector<Rational> values_at_openings(const Gradation &g, const MassLaw &law) {
  assert(!law.is_power());
  std::vector<Rational> values;
  values.reserve(g.classes() + 1);
  for (const Rational &x : g.sizes())
    values.push_back(law.powered(x));
  return values;
}

Problem::Problem(const Gradation &g, const MassLaw &law, const Integer &min_per_class)
    : law_(law), root_(g.root()) {
  const std::vector<Rational> values = law.is_power() ? std::vector<Rational>() : values_at_openings(g, law);
  const std::vector<Rational> &openings = law.is_power() ? g.powers() : values;
  check_powers(g, openings, law, min_per_class);
  CommonDenominator sizes(openings);
  const unsigned p = scale_power();
  const CommonDenominator masses(g.masses());
  for (Integer &x : sizes.numerators)
    x = power(x, law.a);
  scale_unit_ = ratio(power(masses.denominator, p), power(sizes.denominator, law.a));
  weight_ = weight_of(g, masses);
  classes_.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.mass(j) != 0)
      classes_.push_back({j, sizes.numerators[j], sizes.numerators[j + 1], power(masses.numerators[j], p),
                          std::max(min_per_class, Integer(1))});
  if (g.has_factors())
    multiply(g.factors());
  assert(holds_invariant());
}

void Problem::multiply(const std::vector<Rational> &by) {
  const CommonDenominator factors(by);
  for (ProblemClass &c : classes_) {
    const Integer factor = power(factors.numerators[c.index], scale_power());
    c.f *= factor;
    c.F *= factor;
  }
  scale_unit_ /= Rational(power(factors.denominator, scale_power()));
}

bool Problem::holds_invariant() const {
  return !classes_.empty() && std::all_of(classes_.begin(), classes_.end(), [](const ProblemClass &c) {
    return c.f >= 0 && c.f < c.F && c.mass > 0 && c.floor >= 1;
  });
}

Problem Problem::from_scale(const Rational &start, bool open) const {
  const Integer n = numerator(start);
  const Integer d = denominator(start);
  Problem higher = *this;
  for (ProblemClass &c : higher.classes_) {
    // Least q with q^p F / m >= start (or > start). Over the integers q^p >= y means q^p >= ceil(y), and q^p
    // > y means q^p >= floor(y) + 1; the least q with q^p >= y is floor_root(y - 1) + 1.
    const Integer below = open ? floor_div(n * c.mass, d * c.F) : Integer(ceil_div(n * c.mass, d * c.F) - 1);
    if (below >= 0)
      c.floor = std::max(c.floor, Integer(floor_root(below, scale_power()) + 1));
  }
  return higher;
}

Problem Problem::with_floor(std::size_t j, const Integer &least) const {
  Problem higher = *this;
  higher.classes_[j].floor = std::max(higher.classes_[j].floor, least);
  return higher;
}

Rational Problem::lowest_scale(const std::vector<Integer> &q) const {
  return extreme_scale(classes_, q, scale_power(), &ProblemClass::f, true);
}

Rational Problem::highest_scale(const std::vector<Integer> &q) const {
  return extreme_scale(classes_, q, scale_power(), &ProblemClass::F, false);
}

Integer total(const std::vector<Integer> &q) {
  Integer sum = 0;
  for (const Integer &n : q)
    sum += n;
  return sum;
}

} // namespace mdm
