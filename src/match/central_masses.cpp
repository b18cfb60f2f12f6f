#include "match/simplex.hpp"
#include "match/tolerant_match.hpp"

namespace mdm {
namespace {

/// The width between the two bounds that a condition is one of, in its units: the least distance from it is
/// measured in it. 0 for a condition without.
Rational width_of(const LinearRow &row, const TolerantProblem &problem, const TolerantMatch &match,
                  const Rational &mass) {
  switch (row.condition) {
  case TolerantCondition::above_lower:
  case TolerantCondition::up_to_upper:
    return Rational((problem.F(row.j) - problem.f(row.j)) * match.q[row.j]);
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

} // namespace

std::optional<std::vector<Rational>> central_masses(const TolerantProblem &problem,
                                                    const TolerantMatch &match,
                                                    const std::optional<Rational> &weight,
                                                    const Rational &excess, const Watch &watch) {
  const std::size_t k = problem.classes();
  const std::size_t distance = problem.variables(); // 1 - the least distance
  Rational mass = 0;
  for (const Rational &t : match.t)
    mass += t;
  Simplex program(problem.variables() + 1, watch);
  program.set_lower(distance, Infinitesimal{});
  for (std::size_t j = 0; j < k; ++j) {
    program.set_lower(j, Infinitesimal{Rational(match.q[j]), 0});
    program.set_upper(j, Infinitesimal{Rational(match.q[j]), 0});
  }
  for (std::size_t p = 2 * k; p < problem.variables(); ++p)
    program.set_lower(p, Infinitesimal{});
  std::optional<std::size_t> weight_form;
  for (const LinearRow &row : problem.rows()) {
    const std::size_t form = program.add_form(row.terms);
    const bool strict = row.condition == TolerantCondition::some_mass ||
                        (row.condition == TolerantCondition::above_lower && match.q[row.j] >= 1);
    program.set_lower(form, Infinitesimal{row.constant, strict ? 1 : 0});
    if (row.condition == TolerantCondition::weight) {
      weight_form = form;
      program.set_lower(form, Infinitesimal{Rational(*weight * problem.unit()), 0});
      program.set_upper(form, Infinitesimal{Rational(*weight * (1 + excess) * problem.unit()), 0});
    }
    const Rational width = width_of(row, problem, match, mass);
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

} // namespace mdm
