#include <mdm/error.hpp>
#include <mdm/match/tolerant_answer.hpp>
#include <mdm/number/pi.hpp>

namespace mdm {
namespace {

/// Sizes and shares of the best match.
void complete(TolerantAnswer &answer, const Gradation &g, const MassLaw &law, unsigned digits) {
  const TolerantMatch &best = *answer.found.best;
  Rational mass = 0;
  for (const Rational &t : best.t)
    mass += t;
  answer.mass = mass / answer.problem.unit();
  for (std::size_t j = 0; j < g.classes(); ++j) {
    answer.weight += best.t[j] / (g.factor(j) * answer.problem.unit());
    answer.shares.push_back(best.t[j] / mass);
    answer.sizes.emplace_back();
    if (best.q[j] == 0)
      continue;
    const Rational one = best.t[j] / (Rational(best.q[j]) * g.factor(j) * answer.problem.unit());
    answer.sizes.back() =
        enclose_size(g, j, law, power(numerator(one), law.b), power(denominator(one), law.b), digits);
  }
}

} // namespace

TolerantAnswer tolerant_answer(const Gradation &g, const Question &question, const std::vector<Integer> &q,
                               const Rational &s, const Limits &limits, unsigned digits) {
  const Tolerance tolerance = tolerance_of(g, question.tolerances, question.band, question.size_factor);
  const Rational excess = 1 / Rational(power_of_ten(digits));
  // A volume demands an irrational weight between two bounds: fewer particles are refuted at the lower, the
  // match holds the upper. Where these differ in N, pi is made more precise.
  for (unsigned places = std::min(digits + 30, most_pi_places);;
       places = std::min(2 * places, most_pi_places)) {
    TolerantDemands demands{question.min_per_class, question.at_least, std::nullopt};
    Rational weight = 0;
    if (question.solids) {
      const StartScale bounds = start_scale(*question.solids, 1, places);
      demands.weight = bounds.lo;
      weight = bounds.hi;
    }
    TolerantAnswer answer{tolerance, TolerantProblem(g, question.law, tolerance, demands), {}, {}, {}, 0, 0,
                          {}};
    TolerantMatch exact{q, {}};
    for (std::size_t j = 0; j < g.classes(); ++j)
      exact.t.push_back(s * g.mass(j) * answer.problem.unit());
    answer.found = tolerant_match(answer.problem, limits, exact);
    if (question.solids && *demands.weight != weight)
      answer.pi = enclose_pi(places);
    if (!answer.found.best)
      return answer;
    if (std::optional<std::vector<Rational>> t =
            central_masses(answer.problem, *answer.found.best, weight, excess)) {
      answer.found.best->t = std::move(*t);
      complete(answer, g, question.law, digits);
      return answer;
    }
    if (places == most_pi_places)
      throw InputError(
          "the volume is so close to that of a match that 1000 digits of pi do not decide: change it");
  }
}

} // namespace mdm
