// The problem within a tolerance in integers (Theorem 12). What comes in are a gradation, a law that is
// rational at the openings, and bounds on shares; what goes out are f_j and F_j as integers in one unit of
// mass, and all conditions as linear rows in counts q, masses t and excesses p. Bounds on shares are
// multiplied by the total mass M = sum of t, so that they are linear. is_match() decides whether counts and
// masses are a match: it alone says so, whoever proposes them.

#include "match/tolerant_problem.hpp"

#include "match/problem.hpp"
#include "number/common_denominator.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>

namespace mdm {
namespace {

using Terms = std::vector<std::pair<std::size_t, Rational>>;

/// f at every opening; rational there, or refused.
std::vector<Rational> masses_at_openings(const Gradation &g, const MassLaw &law) {
  if (!law.is_power())
    return values_at_openings(g, law);
  std::vector<Rational> masses;
  for (const Rational &x : g.powers()) {
    const std::optional<Rational> mass = exact_root(law.powered(x), law.b * g.root());
    if (!mass && g.root() > 1)
      throw InputError(
          "a tolerance needs exact masses, and openings of phi that is no whole number make them "
          "irrational with the law x^(" +
          law.exponent() + "): " + std::string(g.fractions_remedy()));
    if (!mass)
      throw InputError(
          "the law x^(" + law.exponent() +
          ") is irrational at an opening, and a tolerance needs exact masses: use a law with a whole "
          "exponent");
    masses.push_back(*mass);
  }
  return masses;
}

/// The conditions of a problem with the tolerance on masses: share * M is linear, as M is the sum of all.
class Rows {
public:
  explicit Rows(const TolerantProblem &problem) : problem_(problem), k_(problem.classes()) {}

  std::vector<LinearRow> all() {
    Terms counts, masses, weights;
    for (std::size_t j = 0; j < k_; ++j) {
      add(TolerantCondition::above_lower, j, {{j, Rational(-problem_.f(j))}, {k_ + j, 1}});
      add(TolerantCondition::up_to_upper, j, {{j, Rational(problem_.F(j))}, {k_ + j, -1}});
      counts.emplace_back(j, 1);
      masses.emplace_back(k_ + j, 1);
      weights.emplace_back(k_ + j, problem_.per_mass(j));
    }
    const Tolerance &tolerance = problem_.tolerance();
    for (std::size_t j = 0; j < tolerance.retained.size(); ++j)
      add_share(TolerantCondition::retained_lo, TolerantCondition::retained_hi, j, j, tolerance.retained[j]);
    for (std::size_t j = 0; j < tolerance.passing.size(); ++j)
      add_share(TolerantCondition::passing_lo, TolerantCondition::passing_hi, j, 0, tolerance.passing[j]);
    if (tolerance.total)
      add_total(*tolerance.total);
    add(TolerantCondition::some_mass, 0, masses);
    if (problem_.weight())
      add(TolerantCondition::weight, 0, weights, *problem_.weight());
    add(TolerantCondition::at_least, 0, counts, Rational(problem_.at_least()));
    return std::move(rows_);
  }

private:
  void add(TolerantCondition condition, std::size_t j, Terms terms, const Rational &constant = 0,
           const Rational &width = 0) {
    rows_.push_back({condition, j, std::move(terms), constant, width});
  }

  /// sign * (sum of t over [from, to) - share * M)
  Terms deviation(int sign, std::size_t from, std::size_t to, const Rational &share) const {
    Terms terms;
    for (std::size_t i = 0; i < k_; ++i) {
      const Rational c = sign * (Rational(i >= from && i < to ? 1 : 0) - share);
      if (c != 0)
        terms.emplace_back(k_ + i, c);
    }
    return terms;
  }

  /// Bounds on the masses of the classes from `from` to j.
  void add_share(TolerantCondition lo, TolerantCondition hi, std::size_t j, std::size_t from,
                 const ShareBounds &b) {
    if (b.lo > 0)
      add(lo, j, deviation(1, from, j + 1, b.lo), 0, Rational(b.hi - b.lo));
    if (b.hi < 1)
      add(hi, j, deviation(-1, from, j + 1, b.hi), 0, Rational(b.hi - b.lo));
  }

  void add_total(const Rational &most) {
    Terms total;
    for (std::size_t j = 0; j < k_; ++j) {
      Terms terms = deviation(-1, j, j + 1, problem_.target()[j]);
      terms.emplace_back(2 * k_ + j, 1);
      add(TolerantCondition::excess, j, std::move(terms));
      total.emplace_back(k_ + j, most / 2);
    }
    for (std::size_t j = 0; j < k_; ++j)
      total.emplace_back(2 * k_ + j, -1);
    add(TolerantCondition::excess_total, 0, std::move(total), 0, Rational(most / 2));
  }

  const TolerantProblem &problem_;
  std::size_t k_;
  std::vector<LinearRow> rows_;
};

bool is_within(const ShareBounds &b, const Rational &part, const Rational &all) {
  return b.lo * all <= part && part <= b.hi * all;
}

} // namespace

TolerantProblem::TolerantProblem(const Gradation &g, const MassLaw &law, const Tolerance &tolerance,
                                 const TolerantDemands &demands)
    : tolerance_(tolerance), target_(shares(g)), at_least_(std::max(demands.at_least, Integer(1))) {
  const std::size_t k = g.classes();
  variables_ = (tolerance.total ? 3 : 2) * k;
  const CommonDenominator openings(masses_at_openings(g, law));
  const CommonDenominator factors(g.has_factors() ? g.factors() : std::vector<Rational>(k, Rational(1)));
  unit_ = Rational(openings.denominator * factors.denominator);
  if (demands.weight)
    weight_ = Rational(*demands.weight * unit_);
  for (std::size_t j = 0; j < k; ++j) {
    // Between two materials there is no class: its bounds mean nothing, as the tolerance lets it have no
    // mass.
    f_.push_back(g.is_class(j) ? Integer(openings.numerators[j] * factors.numerators[j]) : Integer(0));
    F_.push_back(g.is_class(j) ? Integer(openings.numerators[j + 1] * factors.numerators[j]) : Integer(1));
    least_.push_back(g.mass(j) > 0 ? demands.min_per_class : Integer(0));
    per_mass_.push_back(ratio(factors.denominator, factors.numerators[j]));
  }
}

std::vector<LinearRow> TolerantProblem::rows() const {
  return Rows(*this).all();
}

std::size_t TolerantProblem::table_size() const {
  const std::size_t k = classes();
  const std::size_t rows =
      2 * (k + tolerance_.retained.size() + tolerance_.passing.size()) + (tolerance_.total ? k + 1 : 0) + 3;
  return rows * variables_;
}

bool TolerantProblem::has_shares(const std::vector<Rational> &t) const {
  const Rational mass = sum(t);
  if (mass <= 0)
    return false;
  for (std::size_t j = 0; j < tolerance_.retained.size(); ++j)
    if (!is_within(tolerance_.retained[j], t[j], mass))
      return false;
  Rational passing = 0;
  for (std::size_t j = 0; j < tolerance_.passing.size(); ++j) {
    passing += t[j];
    if (!is_within(tolerance_.passing[j], passing, mass))
      return false;
  }
  if (!tolerance_.total)
    return true;
  std::vector<Rational> excesses;
  for (std::size_t j = 0; j < classes(); ++j)
    excesses.push_back(std::max(Rational(0), Rational(t[j] - target_[j] * mass)));
  return sum(excesses) <= *tolerance_.total / 2 * mass;
}

bool TolerantProblem::is_match(const std::vector<Integer> &q, const std::vector<Rational> &t) const {
  Integer particles = 0;
  std::vector<Rational> weights;
  for (std::size_t j = 0; j < classes(); ++j) {
    const Rational above = f_[j] * Rational(q[j]);
    if (q[j] < least_[j] || t[j] < above || (q[j] >= 1 && t[j] == above) || t[j] > F_[j] * Rational(q[j]))
      return false;
    particles += q[j];
    if (weight_)
      weights.push_back(t[j] * per_mass_[j]);
  }
  return particles >= at_least_ && (!weight_ || sum(weights) >= *weight_) && has_shares(t);
}

} // namespace mdm
