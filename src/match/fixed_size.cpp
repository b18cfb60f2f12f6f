// The approximate match (Eq. 18) and the fixed size algorithm of Arnold's paper, as printed. Sizes are
// chosen beforehand, one a class, so that every particle stays in its class. For i = 1, 2, ... the
// reference class has i particles and the others int(i K_j); the first i whose largest error of shares in
// sum is within the tolerance ends it, or the last one that is allowed. Errors are exact fractions. It
// never claims a match: what comes out is as near as rounding gets.

#include "match/fixed_size.hpp"

#include "number/common_denominator.hpp"

namespace mdm {

Integer rounded(const Rational &r, Rounding rounding) {
  switch (rounding) {
  case Rounding::up:
    return ceil(r);
  case Rounding::down:
    return floor(r);
  default:
    break;
  }
  static const Rational half = ratio(1, 2);
  const Integer n = floor(Rational(r + half));
  const bool tie = Rational(n) == r + half;
  return tie && rounding == Rounding::even && n % 2 != 0 ? Integer(n - 1) : n;
}

Published fixed_size(const Gradation &g, const MassLaw &law, const FixedSizeOptions &options) {
  const std::vector<Rational> particles = particle_masses(g, law, options.sizes);
  Published run;
  run.phi = mass_ratios(g);
  run.least_zeta = volume_ratios(particles, reference_class(g));
  run.most_zeta.assign(run.least_zeta.begin(), run.least_zeta.end());
  const std::vector<Rational> kappa = quantity_ratios(run.phi, run.least_zeta);
  const CommonDenominator unit_masses(particles);
  std::vector<Integer> target = CommonDenominator(g.masses()).numerators;
  target.pop_back();
  for (std::uint64_t i = 1; i <= options.max_iterations && !run.reached; ++i) {
    PublishedTry t;
    t.multiple = i;
    std::vector<Integer> held;
    for (std::size_t j = 0; j < g.classes(); ++j) {
      t.q.push_back(rounded(Rational(i) * kappa[j], options.rounding));
      held.push_back(t.q[j] * unit_masses.numerators[j]);
    }
    t.error = class_errors(held, target);
    run.reached = t.error.total <= options.tolerance;
    run.tries.push_back(std::move(t));
  }
  for (std::size_t j = 0; j < g.classes(); ++j)
    run.powers.push_back(run.result().q[j] == 0 ? Rational(0) : Rational(particles[j] / g.factor(j)));
  return run;
}

} // namespace mdm
