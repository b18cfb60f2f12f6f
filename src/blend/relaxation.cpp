// Blends with real shares: the linear program of Theorem 22 in fractions. What comes in are bounds on
// shares that a search changes; what goes out is the least value, shares that have it, or multiples that
// add up to a contradiction (Farkas).
//
// Variables are the shares, and for aims at targets one deviation a sieve, or one for all. A deviation is
// at least the difference from the target in both directions. The sum of squares has its least value at the
// point of the polytope that is nearest to the target, which is found with linear programs along directions
// (nearest_point.cpp). first_shares() makes one share after the
// other as small as it can be while the value stays the least. What the simplex method gives as a
// contradiction are the numbers lambda, mu, alpha and beta of the theorem; those of bounds on shares follow
// from them and are left out.

#include "blend/relaxation.hpp"

#include <algorithm>

namespace mdm {
namespace {

using Terms = std::vector<std::pair<std::size_t, Rational>>;

Terms passing_terms(const BlendProblem &p, std::size_t sieve) {
  Terms terms;
  for (std::size_t i = 0; i < p.stockpiles.size(); ++i)
    if (p.stockpiles[i].passing[sieve] != 0)
      terms.emplace_back(i, p.stockpiles[i].passing[sieve]);
  return terms;
}

Simplex::Bound bound_at(const Rational &value) {
  return Infinitesimal{value, 0};
}

} // namespace

std::vector<BlendRelaxation::Soft> BlendRelaxation::soft_limits(const BlendProblem &p) {
  using Kind = BlendLimit::Kind;
  std::vector<Soft> soft;
  const std::size_t k = p.stockpiles.size();
  if (p.aim == BlendAim::deviation || p.aim == BlendAim::max_deviation)
    for (std::size_t s = 0; s < p.sieves.size(); ++s)
      for (const bool is_upper : {false, true})
        if (p.sieves[s].is_sieve())
          soft.push_back({{Kind::target, s, is_upper},
                          p.aim == BlendAim::deviation ? k + s : k,
                          p.sieves[s].target.value()});
  if (p.aim == BlendAim::widening)
    for (const std::size_t s : p.widened)
      for (const bool is_upper : {false, true})
        if (is_upper ? p.sieves[s].most < 100 : p.sieves[s].least > 0)
          soft.push_back({{Kind::passing, s, is_upper}, k, is_upper ? p.sieves[s].most : p.sieves[s].least});
  return soft;
}

std::size_t BlendRelaxation::further_variables(const BlendProblem &p) {
  switch (p.aim) {
  case BlendAim::deviation:
    return p.sieves.size();
  case BlendAim::max_deviation:
  case BlendAim::widening:
    return 1;
  default:
    return 0;
  }
}

BlendRelaxation::BlendRelaxation(const BlendProblem &problem, const Watch &watch)
    : problem_(problem), soft_(soft_limits(problem)), further_(further_variables(problem)),
      program_(problem.stockpiles.size() + further_, watch) {
  add_forms();
  set_bounds();
}

bool BlendRelaxation::is_widened(std::size_t sieve) const {
  return problem_.aim == BlendAim::widening &&
         std::find(problem_.widened.begin(), problem_.widened.end(), sieve) != problem_.widened.end();
}

void BlendRelaxation::add_forms() {
  const std::size_t k = problem_.stockpiles.size();
  Terms all, costs, deviations;
  for (std::size_t i = 0; i < k; ++i) {
    all.emplace_back(i, 1);
    costs.emplace_back(i, problem_.stockpiles[i].cost);
  }
  for (std::size_t d = 0; d < further_; ++d)
    deviations.emplace_back(k + d, 1);
  sum_ = program_.add_form(all);
  first_passing_ = sum_ + 1;
  for (std::size_t s = 0; s < problem_.sieves.size(); ++s)
    program_.add_form(passing_terms(problem_, s));
  for (Soft &soft : soft_) {
    Terms terms = passing_terms(problem_, soft.limit.index);
    terms.emplace_back(soft.by, soft.limit.is_upper ? -1 : 1);
    soft.form = program_.add_form(terms);
  }
  if (further_ == 1)
    aim_ = k;
  else
    aim_ = program_.add_form(problem_.aim == BlendAim::cost ? costs : deviations);
}

void BlendRelaxation::set_bounds() {
  const std::size_t k = problem_.stockpiles.size();
  for (std::size_t i = 0; i < k; ++i)
    bound_share(i, problem_.stockpiles[i].least, problem_.stockpiles[i].most);
  for (std::size_t d = 0; d < further_; ++d)
    program_.set_lower(k + d, bound_at(0));
  if (problem_.aim != BlendAim::squares)
    program_.set_lower(aim_, bound_at(0));
  program_.set_lower(sum_, bound_at(1));
  program_.set_upper(sum_, bound_at(1));
  for (std::size_t s = 0; s < problem_.sieves.size(); ++s) {
    if (is_widened(s))
      continue;
    if (problem_.sieves[s].least > 0)
      program_.set_lower(first_passing_ + s, bound_at(problem_.sieves[s].least));
    if (problem_.sieves[s].most < 100)
      program_.set_upper(first_passing_ + s, bound_at(problem_.sieves[s].most));
  }
  for (const Soft &soft : soft_)
    if (soft.limit.is_upper)
      program_.set_upper(soft.form, bound_at(soft.value));
    else
      program_.set_lower(soft.form, bound_at(soft.value));
}

void BlendRelaxation::bound_share(std::size_t stockpile, const Rational &least, const Rational &most) {
  program_.set_lower(stockpile, bound_at(least));
  // That a share is at most 1 the sum says already.
  program_.set_upper(stockpile, most < 1 ? bound_at(most) : std::nullopt);
}

void BlendRelaxation::set_limit(const BlendLimit &limit, const Simplex::Bound &bound) {
  const std::size_t variable =
      limit.kind == BlendLimit::Kind::share ? limit.index : first_passing_ + limit.index;
  if (limit.is_upper)
    program_.set_upper(variable, bound);
  else
    program_.set_lower(variable, bound);
}

void BlendRelaxation::leave_out(const BlendLimit &limit) {
  const bool is_least_share = limit.kind == BlendLimit::Kind::share && !limit.is_upper;
  set_limit(limit, is_least_share ? bound_at(0) : std::nullopt);
}

void BlendRelaxation::take_back(const BlendLimit &limit) {
  set_limit(limit, bound_at(value_of(limit, problem_)));
}

void BlendRelaxation::demand_less(const Rational &value) {
  program_.set_upper(aim_, Infinitesimal{value, -1});
}

bool BlendRelaxation::is_feasible() {
  return program_.find(aim_);
}

std::optional<Rational> BlendRelaxation::least_value() {
  if (!is_feasible())
    return std::nullopt;
  if (problem_.aim == BlendAim::squares) {
    nearest_ = nearest_point(placed(values_of_shares()), [this](const std::vector<Rational> &direction) {
      aim_along(direction);
      program_.minimise(aim_);
      return placed(values_of_shares());
    });
    return scalar_product(nearest_.place, nearest_.place);
  }
  program_.minimise(aim_);
  return program_.value(aim_).value;
}

/// The deviations from the target of what shares let pass, one a sieve; 0 of those without one.
PlacedPoint BlendRelaxation::placed(const std::vector<Rational> &shares) const {
  std::vector<Rational> deviations(problem_.sieves.size());
  for (std::size_t s = 0; s < deviations.size(); ++s) {
    if (!problem_.sieves[s].target)
      continue;
    deviations[s] = -*problem_.sieves[s].target;
    for (std::size_t i = 0; i < shares.size(); ++i)
      deviations[s] += shares[i] * problem_.stockpiles[i].passing[s];
  }
  return {shares, deviations};
}

/// Lets the aim be the scalar product of the deviations with a direction, up to a constant.
void BlendRelaxation::aim_along(const std::vector<Rational> &direction) {
  Terms terms;
  for (std::size_t i = 0; i < problem_.stockpiles.size(); ++i)
    terms.emplace_back(i, scalar_product(direction, problem_.stockpiles[i].passing));
  program_.change_form(aim_, terms);
}

std::vector<Rational> BlendRelaxation::some_shares() const {
  return problem_.aim == BlendAim::squares ? nearest_.shares : values_of_shares();
}

std::vector<Rational> BlendRelaxation::values_of_shares() const {
  std::vector<Rational> shares;
  for (std::size_t i = 0; i < problem_.stockpiles.size(); ++i)
    shares.push_back(program_.value(i).value);
  return shares;
}

std::vector<Rational> BlendRelaxation::first_shares() {
  if (problem_.aim == BlendAim::squares)
    return first_shares_of_squares();
  program_.set_upper(aim_, program_.value(aim_));
  std::vector<Rational> shares = first_of_kept();
  program_.set_upper(aim_, std::nullopt);
  return shares;
}

/// All shares with the least squares let the same pass each sieve: between two others there are less.
std::vector<Rational> BlendRelaxation::first_shares_of_squares() {
  std::vector<std::pair<Simplex::Bound, Simplex::Bound>> bounds;
  for (std::size_t s = 0; s < problem_.sieves.size(); ++s) {
    const std::size_t form = first_passing_ + s;
    bounds.emplace_back(program_.lower(form), program_.upper(form));
    if (!problem_.sieves[s].target)
      continue;
    const Simplex::Bound passing = bound_at(nearest_.place[s] + *problem_.sieves[s].target);
    program_.set_lower(form, passing);
    program_.set_upper(form, passing);
  }
  is_feasible();
  std::vector<Rational> shares = first_of_kept();
  for (std::size_t s = 0; s < bounds.size(); ++s) {
    program_.set_lower(first_passing_ + s, bounds[s].first);
    program_.set_upper(first_passing_ + s, bounds[s].second);
  }
  return shares;
}

/// The shares that come first of those within all bounds.
std::vector<Rational> BlendRelaxation::first_of_kept() {
  std::vector<Rational> shares;
  std::vector<Simplex::Bound> most;
  for (std::size_t i = 0; i < problem_.stockpiles.size(); ++i) {
    most.push_back(program_.upper(i));
    program_.minimise(i);
    shares.push_back(program_.value(i).value);
    program_.set_upper(i, bound_at(shares.back()));
  }
  for (std::size_t i = 0; i < most.size(); ++i)
    program_.set_upper(i, most[i]);
  return shares;
}

bool BlendRelaxation::needs_aim() const {
  const std::vector<Simplex::Term> &terms = program_.conflict();
  return std::any_of(terms.begin(), terms.end(),
                     [this](const Simplex::Term &t) { return t.variable == aim_ && t.is_upper; });
}

std::vector<BlendMultiple> BlendRelaxation::multiples() const {
  using Kind = BlendLimit::Kind;
  Rational of_aim = 1;
  for (const Simplex::Term &term : program_.conflict())
    if (term.variable == aim_ && term.is_upper)
      of_aim = term.multiplier;
  std::vector<BlendMultiple> multiples;
  for (const Simplex::Term &term : program_.conflict()) {
    const Rational m = term.multiplier / of_aim;
    const std::size_t v = term.variable;
    if (v < problem_.stockpiles.size()) {
      if (term.is_upper || program_.lower(v)->value > 0)
        multiples.push_back({{Kind::share, v, term.is_upper}, m});
    } else if (v == sum_) {
      multiples.push_back({{Kind::sum, 0, false}, term.is_upper ? Rational(-m) : m});
    } else if (v >= first_passing_ && v < first_passing_ + problem_.sieves.size()) {
      multiples.push_back({{Kind::passing, v - first_passing_, term.is_upper}, m});
    } else {
      for (const Soft &soft : soft_)
        if (soft.form == v)
          multiples.push_back({soft.limit, m});
    }
  }
  return multiples;
}

} // namespace mdm
