// Masses for given counts that are far from all bounds. Whether counts are a match is a linear program in
// the masses; here its least distance to any bound, each by the width between it and its opposite, is made
// as great as can be, so that sizes are not at sieves and shares not at their limits. Doubles find such
// masses mostly, and what they find is tested exactly; where they do not tell, the same program is solved
// in fractions with strict bounds.

#include "match/central_masses.hpp"

#include "match/problem.hpp"
#include "match/quick_masses.hpp"
#include "match/simplex.hpp"

namespace mdm {
namespace {

/// The width between the two bounds that a condition is one of, in its units: the least distance from it is
/// measured in it. 0 for a condition without.
Rational width_of(const LinearRow &row, const TolerantProblem &problem, const std::vector<Integer> &q,
                  const Rational &mass) {
  switch (row.condition) {
  case TolerantCondition::above_lower:
  case TolerantCondition::up_to_upper:
    return Rational((problem.F(row.j) - problem.f(row.j)) * q[row.j]);
  case TolerantCondition::retained_lo:
  case TolerantCondition::retained_hi:
  case TolerantCondition::passing_lo:
  case TolerantCondition::passing_hi:
  case TolerantCondition::excess_total:
    return row.width * mass;
  default:
    return 0;
  }
}

std::optional<std::vector<Rational>> exact_masses(const TolerantProblem &problem,
                                                  const std::vector<Integer> &q,
                                                  const std::optional<Rational> &weight,
                                                  const Rational &excess, const Watch &watch) {
  const std::size_t k = problem.classes();
  const std::size_t distance = problem.variables(); // 1 - the least distance
  Rational mass = 0;                                // about that of the match
  for (std::size_t j = 0; j < k; ++j)
    mass += ratio((problem.f(j) + problem.F(j)) * q[j], 2);
  Simplex program(problem.variables() + 1, watch);
  program.set_lower(distance, Infinitesimal{});
  for (std::size_t j = 0; j < k; ++j) {
    program.set_lower(j, Infinitesimal{Rational(q[j]), 0});
    program.set_upper(j, Infinitesimal{Rational(q[j]), 0});
  }
  for (std::size_t p = 2 * k; p < problem.variables(); ++p)
    program.set_lower(p, Infinitesimal{});
  std::optional<std::size_t> weight_form;
  for (const LinearRow &row : problem.rows()) {
    const std::size_t form = program.add_form(row.terms);
    const bool strict = row.condition == TolerantCondition::some_mass ||
                        (row.condition == TolerantCondition::above_lower && q[row.j] >= 1);
    program.set_lower(form, Infinitesimal{row.constant, strict ? 1 : 0});
    if (row.condition == TolerantCondition::weight && weight) {
      weight_form = form;
      program.set_lower(form, Infinitesimal{Rational(*weight * problem.unit()), 0});
      program.set_upper(form, Infinitesimal{Rational(*weight * (1 + excess) * problem.unit()), 0});
    }
    const Rational width = width_of(row, problem, q, mass);
    if (width == 0)
      continue;
    std::vector<std::pair<std::size_t, Rational>> terms = row.terms;
    terms.emplace_back(distance, width);
    program.set_lower(program.add_form(terms), Infinitesimal{Rational(row.constant + width), 0});
  }
  bool found = program.find(distance);
  if (!found && weight_form) {
    program.set_upper(*weight_form, std::nullopt);
    found = program.find(distance);
  }
  if (!found)
    return std::nullopt;
  program.minimise(distance);
  return program.concrete_values(k, 2 * k);
}

} // namespace

std::optional<std::vector<Rational>> masses_of(const TolerantProblem &problem, const std::vector<Integer> &q,
                                               const Watch &watch) {
  if (total(q) == 0)
    return std::nullopt;
  QuickMasses quick = quick_masses(problem, q);
  if (quick.t || !quick.are_close)
    return std::move(quick.t);
  return exact_masses(problem, q, std::nullopt, 0, watch);
}

std::optional<std::vector<Rational>> central_masses(const TolerantProblem &problem,
                                                    const std::vector<Integer> &q,
                                                    const std::optional<Rational> &weight,
                                                    const Rational &excess, const Watch &watch) {
  // A volume is met more closely than doubles can.
  if (!problem.weight())
    if (QuickMasses quick = quick_masses(problem, q); quick.t)
      return std::move(quick.t);
  return exact_masses(problem, q, weight, excess, watch);
}

} // namespace mdm
