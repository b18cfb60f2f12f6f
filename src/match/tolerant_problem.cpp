#include <mdm/error.hpp>
#include <mdm/match/tolerant_problem.hpp>
#include <mdm/number/common_denominator.hpp>

#include <algorithm>

namespace mdm {
namespace {

using Terms = std::vector<std::pair<std::size_t, Rational>>;

/// f at every opening; rational there, or refused.
std::vector<Rational> masses_at_openings(const Gradation &g, const MassLaw &law) {
  std::vector<Rational> masses;
  for (const Rational &x : g.sizes()) {
    const std::optional<Rational> mass = exact_root(law.powered(x), law.b);
    if (!mass)
      throw InputError(
          "the law x^(" + law.exponent() +
          ") is irrational at an opening, and a tolerance needs exact masses: use a law with a whole "
          "exponent");
    masses.push_back(*mass);
  }
  return masses;
}

} // namespace

TolerantProblem::TolerantProblem(const Gradation &g, const MassLaw &law, const Tolerance &tolerance,
                                 const TolerantDemands &demands) {
  const std::size_t k = g.classes();
  variables_ = (tolerance.total ? 3 : 2) * k;
  const CommonDenominator openings(masses_at_openings(g, law));
  const CommonDenominator factors(g.has_factors() ? g.factors() : std::vector<Rational>(k, Rational(1)));
  unit_ = Rational(openings.denominator * factors.denominator);
  Terms counts, masses, weights;
  for (std::size_t j = 0; j < k; ++j) {
    f_.push_back(openings.numerators[j] * factors.numerators[j]);
    F_.push_back(openings.numerators[j + 1] * factors.numerators[j]);
    least_.push_back(g.mass(j) > 0 ? demands.min_per_class : Integer(0));
    add(TolerantCondition::above_lower, j, {{j, Rational(-f_[j])}, {k + j, 1}});
    add(TolerantCondition::up_to_upper, j, {{j, Rational(F_[j])}, {k + j, -1}});
    counts.emplace_back(j, 1);
    masses.emplace_back(k + j, 1);
    weights.emplace_back(k + j, ratio(factors.denominator, factors.numerators[j]));
  }
  add_share_rows(tolerance, shares(g));
  add(TolerantCondition::some_mass, 0, masses);
  if (demands.weight)
    add(TolerantCondition::weight, 0, weights, *demands.weight * unit_);
  add(TolerantCondition::at_least, 0, counts, Rational(std::max(demands.at_least, Integer(1))));
}

void TolerantProblem::add(TolerantCondition condition, std::size_t j, Terms terms, const Rational &constant,
                          const Rational &width) {
  rows_.push_back({condition, j, std::move(terms), constant, width});
}

/// What a tolerance says of masses: share * M is linear, as M is the sum of all.
void TolerantProblem::add_share_rows(const Tolerance &tolerance, const std::vector<Rational> &target) {
  const std::size_t k = classes();
  // sign * (sum of t over [from, to) - share * M)
  const auto deviation = [k](int sign, std::size_t from, std::size_t to, const Rational &share) {
    Terms terms;
    for (std::size_t i = 0; i < k; ++i) {
      const Rational c = sign * (Rational(i >= from && i < to ? 1 : 0) - share);
      if (c != 0)
        terms.emplace_back(k + i, c);
    }
    return terms;
  };
  for (std::size_t j = 0; j < tolerance.retained.size(); ++j) {
    const ShareBounds &b = tolerance.retained[j];
    if (b.lo > 0)
      add(TolerantCondition::retained_lo, j, deviation(1, j, j + 1, b.lo), 0, Rational(b.hi - b.lo));
    if (b.hi < 1)
      add(TolerantCondition::retained_hi, j, deviation(-1, j, j + 1, b.hi), 0, Rational(b.hi - b.lo));
  }
  for (std::size_t j = 0; j < tolerance.passing.size(); ++j) {
    const ShareBounds &b = tolerance.passing[j];
    if (b.lo > 0)
      add(TolerantCondition::passing_lo, j, deviation(1, 0, j + 1, b.lo), 0, Rational(b.hi - b.lo));
    if (b.hi < 1)
      add(TolerantCondition::passing_hi, j, deviation(-1, 0, j + 1, b.hi), 0, Rational(b.hi - b.lo));
  }
  if (!tolerance.total)
    return;
  Terms total;
  for (std::size_t j = 0; j < k; ++j) {
    Terms terms = deviation(-1, j, j + 1, target[j]);
    terms.emplace_back(2 * k + j, 1);
    add(TolerantCondition::excess, j, std::move(terms));
    total.emplace_back(k + j, *tolerance.total / 2);
  }
  for (std::size_t j = 0; j < k; ++j)
    total.emplace_back(2 * k + j, -1);
  add(TolerantCondition::excess_total, 0, std::move(total), 0, Rational(*tolerance.total / 2));
}

bool TolerantProblem::is_match(const std::vector<Integer> &q, const std::vector<Rational> &t) const {
  const std::size_t k = classes();
  const bool has_total = variables_ == 3 * k;
  std::vector<Rational> x(q.begin(), q.end());
  x.insert(x.end(), t.begin(), t.end());
  if (has_total) // the least excesses that their rows allow
    x.resize(3 * k);
  for (const LinearRow &row : rows_) {
    Rational left = 0;
    for (const auto &[variable, coefficient] : row.terms)
      left += coefficient * x[variable];
    if (row.condition == TolerantCondition::excess) {
      x[2 * k + row.j] = left < 0 ? Rational(-left) : Rational(0);
      continue;
    }
    const bool strict = row.condition == TolerantCondition::some_mass ||
                        (row.condition == TolerantCondition::above_lower && q[row.j] >= 1);
    if (left < row.constant || (strict && left == row.constant))
      return false;
  }
  for (std::size_t j = 0; j < k; ++j)
    if (q[j] < least_[j])
      return false;
  return true;
}

} // namespace mdm
