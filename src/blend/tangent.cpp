#include "blend/tangent.hpp"

#include <algorithm>

namespace mdm {

std::vector<Rational> slopes_at(const BlendProblem &problem, const std::vector<Rational> &passing) {
  std::vector<Rational> slopes(problem.sieves.size());
  for (std::size_t s = 0; s < slopes.size(); ++s)
    if (problem.sieves[s].target)
      slopes[s] = 2 * (passing[s] - *problem.sieves[s].target);
  return slopes;
}

Tangent tangent_with(const BlendProblem &problem, const std::vector<Rational> &slopes) {
  Tangent tangent{problem, 0};
  tangent.problem.aim = BlendAim::cost;
  for (Stockpile &stockpile : tangent.problem.stockpiles) {
    stockpile.cost = 0;
    for (std::size_t s = 0; s < slopes.size(); ++s)
      if (slopes[s] != 0)
        stockpile.cost +=
            slopes[s] * (stockpile.passing[s] - *problem.sieves[s].target) - slopes[s] * slopes[s] / 4;
    tangent.raised = std::max(tangent.raised, Rational(-stockpile.cost));
  }
  for (Stockpile &stockpile : tangent.problem.stockpiles)
    stockpile.cost += tangent.raised;
  return tangent;
}

} // namespace mdm
