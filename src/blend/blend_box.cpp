#include "blend/blend_box.hpp"

#include <mdm/number/integer.hpp>

#include <algorithm>

namespace mdm {

BlendBox whole_box(const BlendProblem &problem) {
  BlendBox box;
  for (const Stockpile &s : problem.stockpiles) {
    box.least.push_back(ceil(s.least * problem.steps).convert_to<std::uint64_t>());
    box.most.push_back(floor(s.most * problem.steps).convert_to<std::uint64_t>());
  }
  return box;
}

bool restrict_box(const BlendProblem &problem, BlendBox &box) {
  const auto used = static_cast<std::size_t>(
      std::count_if(box.least.begin(), box.least.end(), [](std::uint64_t n) { return n > 0; }));
  for (std::size_t i = 0; i < box.least.size(); ++i) {
    if (problem.at_most && used == *problem.at_most && box.least[i] == 0)
      box.most[i] = 0;
    if (box.least[i] > box.most[i])
      return false;
  }
  return !problem.at_most || used <= *problem.at_most;
}

} // namespace mdm
