#include "match/smallest_match.hpp"

#include "match/least_match.hpp"
#include "match/problem.hpp"

#include <mdm/number/decimal.hpp>

namespace mdm {

std::string SmallestMatch::text() const {
  return is_point() ? to_string(lo) : "[" + to_string(lo) + ", " + to_string(hi) + "]";
}

std::string SmallestMatch::ratio_text(const Integer &n) const {
  const auto over = [&n](const Integer &least) { return approximate(ratio(n, least), 4); };
  return is_point() ? over(lo) : "[" + over(hi) + ", " + over(lo) + "]";
}

SmallestMatch smallest_match(const Gradation &g, const MassLaw &law) {
  Limits limits;
  limits.max_steps = most_steps_beside;
  limits.keep_proof = false;
  const Problem problem(g, law, 1);
  const LeastMatch least = least_match(problem, limits);
  return {{total(least.q), least.complete ? total(least.q) : total(some_match(problem))}};
}

} // namespace mdm
