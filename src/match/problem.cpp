#include <mdm/match/problem.hpp>

#include <mdm/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

/// Powers beyond this many bits are refused: the checker has the same limit (certificate-format.md, section 2).
constexpr std::size_t max_power_bits = std::size_t{1} << 20;

std::size_t longest_part(const Rational &r) {
  return std::max(mpz_sizeinbase(mpq_numref(r.backend().data()), 2), mpz_sizeinbase(mpq_denref(r.backend().data()), 2));
}

void check_powers(const Gradation &g, const MassLaw &law, const Integer &min_per_class) {
  std::size_t bits = bit_length(min_per_class);
  for (std::size_t j = 0; j <= g.classes(); ++j)
    bits = std::max({bits, longest_part(g.sizes()[j]), longest_part(g.masses()[j])});
  for (std::size_t j = 0; g.has_factors() && j < g.classes(); ++j)
    bits = std::max(bits, longest_part(g.factor(j)));
  if (bits * std::max(law.a, law.b) > max_power_bits)
    throw InputError("the exponent " + law.exponent() + " is too large for numbers this long: round one of them");
}

} // namespace

Problem::Problem(const Gradation &g, const MassLaw &law, const Integer &min_per_class) : law_(law) {
  check_powers(g, law, min_per_class);
  classes_.reserve(g.classes());
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0)
      continue;
    const Rational c = power(g.factor(j), law.b);
    classes_.push_back({j, c * law.powered(g.lower(j)), c * law.powered(g.upper(j)), power(g.mass(j), law.b), min_per_class});
  }
}

Problem Problem::from_scale(const Rational &start, bool open) const {
  Problem higher = *this;
  for (ProblemClass &c : higher.classes_) {
    // Least q with q^b F / m >= start (or > start). Over the integers q^b >= y means q^b >= ceil(y), and q^b > y means
    // q^b >= floor(y) + 1; the least q with q^b >= n is floor_root(n - 1) + 1.
    const Rational y = start * c.mass / c.F;
    const Integer below = open ? floor(y) : Integer(ceil(y) - 1);
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
  Rational lowest = 0;
  for (std::size_t j = 0; j < q.size(); ++j)
    lowest = std::max(lowest, Rational(Rational(power(q[j], law_.b)) * classes_[j].f / classes_[j].mass));
  return lowest;
}

Rational Problem::highest_scale(const std::vector<Integer> &q) const {
  Rational highest = Rational(power(q[0], law_.b)) * classes_[0].F / classes_[0].mass;
  for (std::size_t j = 1; j < q.size(); ++j)
    highest = std::min(highest, Rational(Rational(power(q[j], law_.b)) * classes_[j].F / classes_[j].mass));
  return highest;
}

Integer total(const std::vector<Integer> &q) {
  Integer sum = 0;
  for (const Integer &n : q)
    sum += n;
  return sum;
}

} // namespace mdm
