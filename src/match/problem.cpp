#include <mdm/error.hpp>
#include <mdm/match/problem.hpp>
#include <mdm/number/common_denominator.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// Powers beyond this many bits are refused: the checker has the same limit (certificate-format.md, section
/// 2).
constexpr std::size_t max_power_bits = std::size_t{1} << 20;

std::size_t bits_of(mpz_srcptr n) {
  return mpz_sizeinbase(n, 2);
}

/// At least the bits, quickly.
std::size_t bits_of_words(mpz_srcptr n) {
  return 64 * mpz_size(n);
}

/// The most bits of a number of the problem.
template <class Bits>
std::size_t longest(const Gradation &g, const Integer &min_per_class, Bits bits) {
  std::size_t most = bits(min_per_class.backend().data());
  const auto add = [&](const std::vector<Rational> &column, std::size_t count) {
    for (std::size_t j = 0; j < count; ++j)
      most = std::max(
          {most, bits(mpq_numref(column[j].backend().data())), bits(mpq_denref(column[j].backend().data()))});
  };
  add(g.sizes(), g.classes() + 1);
  add(g.masses(), g.classes());
  add(g.factors(), g.has_factors() ? g.classes() : 0);
  return most;
}

void check_powers(const Gradation &g, const MassLaw &law, const Integer &min_per_class) {
  const std::size_t degree = std::max(law.a, law.b);
  if (longest(g, min_per_class, bits_of_words) * degree > max_power_bits &&
      longest(g, min_per_class, bits_of) * degree > max_power_bits)
    throw InputError("the exponent " + law.exponent() +
                     " is too large for numbers this long: round one of them");
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

/// The extreme of q^b end / mass over the classes, `end` being f or F: the least, or the greatest. Compared
/// as fractions, reduced only at the end.
Rational extreme_scale(const std::vector<ProblemClass> &classes, const std::vector<Integer> &q, unsigned b,
                       Integer ProblemClass::*end, bool greatest) {
  Integer best, other, left, right;
  const auto multiply = [](Integer &product, const Integer &x, const Integer &y) {
    mpz_mul(product.backend().data(), x.backend().data(), y.backend().data());
  };
  const auto end_of = [&](std::size_t j, Integer &product) {
    multiply(product, b == 1 ? q[j] : power(q[j], b), classes[j].*end);
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

Problem::Problem(const Gradation &g, const MassLaw &law, const Integer &min_per_class) : law_(law) {
  check_powers(g, law, min_per_class);
  CommonDenominator sizes(g.sizes());
  const CommonDenominator masses(g.masses());
  for (Integer &x : sizes.numerators)
    x = power(x, law.a);
  scale_unit_ = ratio(power(masses.denominator, law.b), power(sizes.denominator, law.a));
  weight_ = weight_of(g, masses);
  classes_.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j)
    if (g.mass(j) != 0)
      classes_.push_back({j, sizes.numerators[j], sizes.numerators[j + 1], power(masses.numerators[j], law.b),
                          std::max(min_per_class, Integer(1))});
  if (!g.has_factors())
    return;
  const CommonDenominator factors(g.factors());
  for (ProblemClass &c : classes_) {
    const Integer factor = power(factors.numerators[c.index], law.b);
    c.f *= factor;
    c.F *= factor;
  }
  scale_unit_ /= Rational(power(factors.denominator, law.b));
}

Problem Problem::from_scale(const Rational &start, bool open) const {
  const Integer n = numerator(start);
  const Integer d = denominator(start);
  Problem higher = *this;
  for (ProblemClass &c : higher.classes_) {
    // Least q with q^b F / m >= start (or > start). Over the integers q^b >= y means q^b >= ceil(y), and q^b
    // > y means q^b >= floor(y) + 1; the least q with q^b >= y is floor_root(y - 1) + 1.
    const Integer below = open ? floor_div(n * c.mass, d * c.F) : Integer(ceil_div(n * c.mass, d * c.F) - 1);
    if (below >= 0)
      c.floor = std::max(c.floor, Integer(floor_root(below, law_.b) + 1));
  }
  return higher;
}

Problem Problem::with_floor(std::size_t j, const Integer &least) const {
  Problem higher = *this;
  higher.classes_[j].floor = std::max(higher.classes_[j].floor, least);
  return higher;
}

Rational Problem::lowest_scale(const std::vector<Integer> &q) const {
  return extreme_scale(classes_, q, law_.b, &ProblemClass::f, true);
}

Rational Problem::highest_scale(const std::vector<Integer> &q) const {
  return extreme_scale(classes_, q, law_.b, &ProblemClass::F, false);
}

Integer total(const std::vector<Integer> &q) {
  Integer sum = 0;
  for (const Integer &n : q)
    sum += n;
  return sum;
}

} // namespace mdm
