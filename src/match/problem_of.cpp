#include "match/problem_of.hpp"

namespace mdm {

Problem problem_of(const Match &m) {
  Problem problem(m.gradation, m.question.law, m.question.min_per_class);
  const std::optional<Interval> &start = m.sample->scale->window.start;
  // The bounds of an irrational start are so close that both give the same floors.
  return start ? problem.from_scale(start->lo / problem.scale_unit(), !start->is_point()) : problem;
}

TolerantProblem tolerant_problem_of(const Match &m) {
  TolerantDemands demands{m.question.min_per_class, m.question.at_least, std::nullopt};
  if (m.question.solids)
    demands.weight = start_scale(*m.question.solids, 1, m.proof.pi ? m.proof.pi->places : 1).lo;
  return TolerantProblem(m.gradation, m.question.law, *m.tolerance, demands);
}

std::vector<Rational> powered_masses(const Match &m) {
  const MatchSample &sample = *m.sample;
  std::vector<Rational> masses;
  for (std::size_t j = 0; j < m.gradation.classes(); ++j)
    masses.emplace_back(sample.shares ? sample.mass * power((*sample.shares)[j], m.scale_power())
                                      : sample.scale->chosen * power(m.gradation.mass(j), m.scale_power()));
  return masses;
}

std::vector<Rational> class_masses(const Match &m) {
  const Rational mass = exact_root(m.sample->mass, m.scale_power()).value();
  std::vector<Rational> masses;
  for (const Rational &share : *m.sample->shares)
    masses.emplace_back(mass * share);
  return masses;
}

} // namespace mdm
