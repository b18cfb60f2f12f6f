#include "match/tolerant_answer.hpp"

#include "match/central_masses.hpp"
#include "match/problem.hpp"
#include "match/quick_masses.hpp"
#include "match/simplex.hpp"
#include "number/common_denominator.hpp"
#include "number/pi.hpp"

#include <mdm/text/error.hpp>

#include <algorithm>
#include <iterator>

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
    answer.shares.push_back(best.t[j] / mass);
    answer.sizes.emplace_back();
    if (best.q[j] == 0)
      continue;
    const Rational one = best.t[j] / (Rational(best.q[j]) * g.factor(j) * answer.problem.unit());
    answer.sizes.back() =
        enclose_size(g, j, law, law.a, power(numerator(one), law.b), power(denominator(one), law.b), digits);
  }
}

/// In units of masses.
Rational weight_of(const TolerantProblem &problem, const TolerantMatch &match) {
  std::vector<Rational> weights;
  for (std::size_t j = 0; j < match.t.size(); ++j)
    weights.push_back(match.t[j] * problem.per_mass(j));
  return sum(weights);
}

bool fixes_shares(const Tolerance &tolerance) {
  const auto fixed = [](const ShareBounds &b) { return b.is_point(); };
  const std::vector<ShareBounds> &retained = tolerance.retained, &passing = tolerance.passing;
  return tolerance.total == Rational(0) ||
         (!retained.empty() && std::all_of(retained.begin(), retained.end(), fixed)) ||
         (!passing.empty() && std::all_of(passing.begin(), std::prev(passing.end()), fixed));
}

/// True if the best is the exact match, and no masses in the middle are to be looked for: there are no other
/// shares, or a limit was reached.
bool is_final(const TolerantAnswer &answer, const TolerantMatch &exact) {
  const TolerantMatch &best = *answer.found.best;
  return best.q == exact.q && best.t == exact.t &&
         (!answer.found.complete || fixes_shares(answer.tolerance) ||
          answer.problem.table_size() > largest_table);
}

/// Masses in the middle have some time to themselves.
Watch later(const Watch &watch, const Watch::Deadline &deadline) {
  const Watch::Time soon = std::chrono::steady_clock::now() + std::chrono::milliseconds(500);
  if (watch.is_stopped())
    return Watch(soon);
  return deadline ? watch.until(std::max(*deadline, soon)) : watch;
}

/// The result of a search.
void tell(Progress &known, const TolerantResult &found) {
  known.steps = found.nodes;
  known.lower_bound = found.lower_bound;
  known.particles = total(found.best->q);
}

} // namespace

TolerantAnswer tolerant_answer(const Gradation &g, const Question &question, const std::vector<Integer> &q,
                               const Rational &s, const Limits &limits, unsigned digits, const Watch &watch) {
  const Tolerance tolerance = tolerance_of(g, question.tolerances, question.band, question.size_factor);
  const Rational excess = 1 / Rational(power_of_ten(digits));
  // A volume demands an irrational weight between two bounds: fewer particles are refuted at the lower, the
  // match holds the upper. Where these differ in N, pi is made more precise.
  for (unsigned places = std::min(digits + 30, most_pi_places);;
       places = std::min(2 * places, most_pi_places)) {
    TolerantDemands demands{question.min_per_class, question.at_least, std::nullopt};
    Rational weight = 0;
    if (question.solids) {
      const Interval bounds = start_scale(*question.solids, 1, places);
      demands.weight = bounds.lo;
      weight = bounds.hi;
    }
    TolerantAnswer answer{tolerance, TolerantProblem(g, question.law, tolerance, demands), {}, {}, {}, 0, {}};
    const auto has_weight = [&](const TolerantMatch &match) {
      return answer.problem.is_match(match.q, match.t) &&
             (!question.solids || weight_of(answer.problem, match) >= weight * answer.problem.unit());
    };
    TolerantMatch exact{q, {}};
    for (std::size_t j = 0; j < g.classes(); ++j)
      exact.t.push_back(s * g.mass(j) * answer.problem.unit());
    answer.found = tolerant_match(answer.problem, limits, exact, watch);
    if (question.solids && *demands.weight != weight)
      answer.pi = enclose_pi(places);
    if (!answer.found.best)
      return answer;
    if (is_final(answer, exact) && has_weight(exact)) {
      complete(answer, g, question.law, digits);
      return answer;
    }
    if (!question.solids && answer.problem.table_size() > largest_exact_masses) {
      if (QuickMasses quick = quick_masses(answer.problem, answer.found.best->q); quick.t)
        answer.found.best->t = std::move(*quick.t);
      complete(answer, g, question.law, digits);
      return answer;
    }
    try {
      const Watch watched =
          later(watch, limits.deadline).telling([&](Progress &known) { tell(known, answer.found); });
      if (std::optional<std::vector<Rational>> t =
              central_masses(answer.problem, answer.found.best->q, weight, excess, watched)) {
        answer.found.best->t = std::move(*t);
        complete(answer, g, question.law, digits);
        return answer;
      }
    } catch (const Simplex::Interrupted &) {
      if (!has_weight(*answer.found.best)) {
        answer.found.complete = false;
        answer.found.best.reset();
        if (has_weight(exact))
          answer.found.best = exact;
      }
      if (answer.found.best)
        complete(answer, g, question.law, digits);
      return answer;
    }
    if (places == most_pi_places)
      throw InputError(
          "the volume is so close to that of a match that 1000 digits of pi do not decide: change it");
  }
}

} // namespace mdm
