// From the mass of a particle to its size, x = f^-1(s m_j / (c_j q_j)) (Theorem 9). What comes in is a
// fraction n / d with x^degree = n / d; what goes out are two decimals around x that lie inside of its
// class.
//
// The decimals are those below and above the root, found by integers: floor(10^places x). Windows are
// narrow, so at the digits that were asked for the enclosure may reach over a sieve; then digits are added
// until it does not. That ends: x is above the lower opening, and it is below the upper one or is that
// decimal itself, which is given exactly. An opening that is no decimal and is met exactly is refused.

#include "match/sizes.hpp"

#include "gradation/law_inverse.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <cassert>

namespace mdm {

namespace {

/// Sign of y * 10^-places - r.
int compare(const Integer &y, const Integer &unit, const Rational &r) {
  Integer left, right;
  mpz_mul(left.backend().data(), y.backend().data(), mpq_denref(r.backend().data()));
  mpz_mul(right.backend().data(), unit.backend().data(), mpq_numref(r.backend().data()));
  return mpz_cmp(left.backend().data(), right.backend().data());
}

/// Class j's lower < x.lo and x.hi <= upper, to the power of the root.
bool inside(const Enclosure &x, const Gradation &g, std::size_t j) {
  const Rational &lower = g.powers()[j], &upper = g.powers()[j + 1];
  const Integer unit = power_of_ten(x.places * g.root());
  if (g.root() == 1)
    return compare(x.lo, unit, lower) > 0 && compare(x.hi, unit, upper) <= 0;
  return compare(power(x.lo, g.root()), unit, lower) > 0 && compare(power(x.hi, g.root()), unit, upper) <= 0;
}

} // namespace

Enclosure enclose_size(const Gradation &g, std::size_t j, const MassLaw &law, unsigned degree,
                       const Integer &n, const Integer &d, unsigned digits) {
  const auto is_upper = [&] {
    return law.is_power() ? RootSize{ratio(n, d), degree}.is(g.powers()[j + 1], g.root())
                          : law.powered(g.upper(j)) == ratio(n, d);
  };
  Enclosure x = enclose_inverse(law, n, d, degree, digits);
  for (unsigned more = 2 * digits; !inside(x, g, j); more *= 2) {
    if (x.lo != x.hi && is_upper())
      throw InputError(
          "class " + std::to_string(j + 1) + ": the size is the opening " + g.opening(j + 1).text() +
          " itself, which is no decimal: choose another scale" +
          (g.root() > 1 ? ", or have other openings: " + std::string(g.fractions_remedy()) : ""));
    x = enclose_inverse(law, n, d, degree, more);
  }
  return x;
}

std::vector<Enclosure> enclose_sizes(const Gradation &g, const Problem &problem,
                                     const std::vector<Integer> &q, const Rational &scale,
                                     const Rational &margin, unsigned digits) {
  assert(problem.lowest_scale(q) * problem.scale_unit() < scale &&
         scale <= problem.highest_scale(q) * problem.scale_unit());
  const unsigned p = problem.scale_power();
  const unsigned degree = problem.law().a * problem.root();
  // An enclosure is at most 10^(1-digits) of its size wide: ten times that from the sieves it is inside.
  const bool clear = digits > 1 && margin * power_of_ten(digits) >= 100;
  std::vector<Enclosure> sizes;
  sizes.reserve(q.size());
  Integer n, d;
  Rational quotient;
  for (std::size_t j = 0; j < q.size(); ++j) {
    const std::size_t index = problem.classes()[j].index;
    const Rational &mass = g.has_factors() ? quotient = g.mass(index) / g.factors()[index] : g.mass(index);
    // x^degree = n / d = S (m / (c q))^p
    mpz_pow_ui(n.backend().data(), mpq_numref(mass.backend().data()), p);
    mpz_mul(n.backend().data(), n.backend().data(), mpq_numref(scale.backend().data()));
    mpz_mul(d.backend().data(), mpq_denref(mass.backend().data()), q[j].backend().data());
    mpz_pow_ui(d.backend().data(), d.backend().data(), p);
    mpz_mul(d.backend().data(), d.backend().data(), mpq_denref(scale.backend().data()));
    sizes.push_back(clear ? enclose_inverse(problem.law(), n, d, degree, digits)
                          : enclose_size(g, index, problem.law(), degree, n, d, digits));
  }
  return sizes;
}

namespace {

/// y > 0 with its first three digits, rounded down.
Rational three_digits(const Rational &y) {
  if (y <= 0)
    return 0;
  unsigned places = 0;
  while (y * power_of_ten(places) < 100)
    ++places;
  Integer digits = floor(Rational(y * power_of_ten(places)));
  Integer unit = 1;
  for (; digits >= 1000; digits = floor_div(digits, 10))
    unit *= 10;
  return ratio(digits * unit, power_of_ten(places));
}

} // namespace

Rational size_margin(const Gradation &g, const Problem &problem, const std::vector<Enclosure> &sizes) {
  std::optional<Rational> least;
  const auto see = [&least](const Rational &margin) { least = std::min(least.value_or(margin), margin); };
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::size_t j = problem.classes()[i].index;
    if (g.lower(j) > 0)
      see(sizes[i].lower() / g.lower(j) - 1);
    see(g.upper(j) / sizes[i].upper() - 1);
  }
  return three_digits(*least);
}

Rational size_margin(unsigned degree, const Rational &above, const Rational &up_to, const Rational &scale) {
  // closest = n / d >= 1 is the lesser of up_to / scale and scale / above.
  Integer n = numerator(up_to) * denominator(scale);
  Integer d = denominator(up_to) * numerator(scale);
  if (above > 0) {
    Integer n2 = numerator(scale) * denominator(above);
    Integer d2 = denominator(scale) * numerator(above);
    if (n2 * d < n * d2) {
      n = std::move(n2);
      d = std::move(d2);
    }
  }
  if (n == d)
    return 0;
  // (n/d)^(1/degree) - 1 is about (n - d) / (degree d): so many zeros, then three digits and some more. 3
  // bits are less than a digit.
  const std::size_t large = bit_length(d) + bit_length(degree);
  const std::size_t small = bit_length(Integer(n - d));
  for (unsigned digits = 6 + static_cast<unsigned>(large > small ? (large - small) / 3 : 0);; digits *= 2) {
    const Enclosure root = enclose_root(n, d, degree, digits);
    const Integer excess = root.lo - power_of_ten(root.places);
    if (excess < 1000 && root.lo != root.hi)
      continue;
    const std::size_t length = to_string(excess).size();
    const unsigned surplus = length > 3 ? std::min(static_cast<unsigned>(length - 3), root.places) : 0;
    return ratio(floor_div(excess, power_of_ten(surplus)), power_of_ten(root.places - surplus));
  }
}

} // namespace mdm
