#include <mdm/match/tolerance.hpp>
#include <mdm/number/common_denominator.hpp>

namespace mdm {

std::vector<Rational> shares(const Gradation &g) {
  const Rational all = sum(g.masses());
  std::vector<Rational> result;
  for (std::size_t j = 0; j < g.classes(); ++j)
    result.push_back(g.mass(j) / all);
  return result;
}

} // namespace mdm
