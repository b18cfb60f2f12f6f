#include "match/exact_sample.hpp"

#include "match/sizes.hpp"
#include "number/common_denominator.hpp"

namespace mdm {
namespace {

/// Sum of the masses; without factors the problem has it.
Rational mass_of(const Gradation &g, const Problem &problem) {
  return g.has_factors() ? sum(g.masses()) : problem.weight();
}

} // namespace

MatchSample exact_sample(const Gradation &g, const Problem &problem, std::vector<Integer> q, Window window,
                         const Rational &chosen, unsigned digits) {
  const MassLaw &law = problem.law();
  Rational margin =
      law.is_power() ? size_margin(law.a * problem.root(), window.above, window.up_to, chosen) : Rational(0);
  std::vector<Enclosure> sizes = enclose_sizes(g, problem, q, chosen, margin, digits);
  if (!law.is_power())
    margin = size_margin(g, problem, sizes);
  MatchSample sample;
  sample.quantities.resize(g.classes());
  sample.sizes.resize(g.classes());
  for (std::size_t i = 0; i < q.size(); ++i) {
    const std::size_t j = problem.classes()[i].index;
    sample.quantities[j] = std::move(q[i]);
    sample.sizes[j] = std::move(sizes[i]);
  }
  sample.mass = chosen * power(mass_of(g, problem), problem.scale_power());
  sample.scale = MatchScale{std::move(window), chosen, std::move(margin)};
  return sample;
}

} // namespace mdm
