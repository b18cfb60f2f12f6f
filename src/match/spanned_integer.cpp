// The spanned integer algorithm of Arnold's paper, steps 1 to 6, as printed. What comes in is a gradation
// and the sizes that are to be tried in the reference class, the coarsest with mass; what goes out are all
// its tries and the last one's sample.
//
// For i = 1, 2, ... particles in the reference class, and for each size x_nS of them, every other class
// needs between a_j and b_j particles. The first pair for which ceil(a_j) <= floor(b_j) everywhere gives
// q_j = ceil(a_j). That ends: once i is large enough all intervals are wider than 1; but not with the
// smallest i, as only finitely many sizes are tried (proofs/README.md, "Example: a window between two
// increments").
//
// All is decided in integers, over one denominator for all sizes. Its sample is judged as it is: the
// printed test lets particles have the size of the lower sieve, which is not in the class.

#include "match/spanned_integer.hpp"

#include "match/problem.hpp"
#include "number/common_denominator.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// The problem's scales at which i particles of the r-th size x_nS, r = 0, 1, ..., hold the mass of the
/// reference class: i f(first + r step) unit over one denominator.
class Scales {
public:
  Scales(const Gradation &g, const Problem &problem, const SpannedIntegerOptions &options)
      : law_(problem.law()) {
    const std::size_t j = reference_class(g);
    const Rational first = g.lower(j) + options.start * (g.upper(j) - g.lower(j));
    const Rational step = options.increments == 1
                              ? Rational(0)
                              : Rational((g.upper(j) - first) / Rational(options.increments - 1));
    Rational unit = g.factor(j) / (g.mass(j) * problem.scale_unit());
    if (law_.is_power()) {
      const CommonDenominator sizes({first, step});
      first_ = sizes.numerators[0];
      step_ = sizes.numerators[1];
      unit /= Rational(power(sizes.denominator, law_.a));
    } else {
      std::vector<Rational> values;
      for (std::uint64_t r = 0; r < options.increments; ++r)
        values.push_back(law_.powered(first + step * Rational(r)));
      CommonDenominator cleared(values);
      values_ = std::move(cleared.numerators);
      unit /= Rational(cleared.denominator);
    }
    unit_ = boost::multiprecision::numerator(unit);
    denominator_ = boost::multiprecision::denominator(unit);
  }

  Integer numerator(std::uint64_t i, std::uint64_t r) const {
    return (law_.is_power() ? power(Integer(first_ + step_ * r), law_.a) : values_[r]) * unit_ * i;
  }
  const Integer &denominator() const { return denominator_; }

private:
  const MassLaw &law_;
  Integer first_, step_, unit_, denominator_;
  std::vector<Integer> values_; ///< f at each size, of a law that is no power, over one denominator
};

/// Step 2: ceil(a) <= floor(b) in every class but the reference, which comes last.
bool spans_integers(const Problem &problem, const Integer &n, const Integer &d) {
  const std::vector<ProblemClass> &classes = problem.classes();
  return std::all_of(classes.rbegin() + 1, classes.rend(), [&](const ProblemClass &c) {
    const Integer mass = n * c.mass;
    return ceil_div(mass, d * c.F) * c.f * d <= mass;
  });
}

/// The class, j or a finer one, that a particle with f(x) = x^a lies in; nothing below all.
std::optional<std::size_t> class_of(const Gradation &g, const MassLaw &law, const Rational &x_to_a,
                                    std::size_t j) {
  while (x_to_a <= law.powered(g.lower(j)))
    if (j-- == 0)
      return std::nullopt;
  return j;
}

/// f(x) = s m_j / (c_j q_j) of the particles of each class at the scale s (Eq. 19); 0 where there are none.
std::vector<Rational> size_powers(const Gradation &g, const std::vector<Integer> &q, const Rational &s) {
  std::vector<Rational> powers;
  for (std::size_t j = 0; j < g.classes(); ++j)
    powers.push_back(q[j] == 0 ? Rational(0) : Rational(s * g.mass(j) / (g.factor(j) * Rational(q[j]))));
  return powers;
}

/// Step 5 at a scale of the problem, with i particles in the reference class.
std::vector<Integer> least_quantities(const Gradation &g, const Problem &problem, std::uint64_t i,
                                      const Integer &n, const Integer &d) {
  std::vector<Integer> q(g.classes(), 0);
  for (const ProblemClass &c : problem.classes())
    q[c.index] = ceil_div(n * c.mass, d * c.F);
  q[problem.classes().back().index] = i;
  return q;
}

/// Sieves the particles: each class's mass, in any unit, goes to the class that its size lies in.
ClassErrors sieved_errors(const Gradation &g, const MassLaw &law, const std::vector<Integer> &masses,
                          const std::vector<Rational> &powers) {
  std::vector<Integer> held(masses.size(), 0);
  for (std::size_t j = 0; j < masses.size(); ++j)
    if (const std::optional<std::size_t> in = masses[j] == 0 ? j : class_of(g, law, powers[j], j))
      held[*in] += masses[j];
  return class_errors(held, masses);
}

/// Z at the largest and at the smallest sizes, where a particle of the reference class weighs `reference`.
void set_volume_ratios(Published &run, const Gradation &g, const MassLaw &law, const Rational &reference) {
  const std::size_t n = reference_class(g);
  for (std::size_t j = 0; j < g.classes(); ++j) {
    const Rational lowest = g.factor(j) * law.powered(g.lower(j));
    const Rational highest = g.factor(j) * law.powered(g.upper(j));
    run.least_zeta.push_back(j == n ? Rational(1) : Rational(reference / highest));
    if (j != n && lowest == 0)
      run.most_zeta.emplace_back();
    else
      run.most_zeta.emplace_back(j == n ? Rational(1) : Rational(reference / lowest));
  }
}

} // namespace

Published spanned_integer(const Gradation &g, const MassLaw &law, const SpannedIntegerOptions &options) {
  check_rational(law);
  const Problem problem(g, law, 1);
  const Scales scales(g, problem, options);
  const Integer &d = scales.denominator();
  std::vector<Integer> masses = CommonDenominator(g.masses()).numerators;
  masses.pop_back();
  Published run;
  run.phi = mass_ratios(g);
  Rational scale;
  for (std::uint64_t i = 1; i <= options.max_iterations && !run.reached; ++i) {
    PublishedTry t;
    t.multiple = i;
    Integer n = scales.numerator(i, 0);
    run.reached = spans_integers(problem, n, d);
    for (; !run.reached && t.sizes < options.increments; ++t.sizes) {
      n = scales.numerator(i, t.sizes);
      run.reached = spans_integers(problem, n, d);
    }
    scale = ratio(n, d) * problem.scale_unit();
    t.q = least_quantities(g, problem, i, n, d);
    run.powers = size_powers(g, t.q, scale);
    t.error = sieved_errors(g, law, masses, run.powers);
    run.tries.push_back(std::move(t));
  }
  const Rational reference = scale * g.mass(reference_class(g)) / Rational(run.result().multiple);
  set_volume_ratios(run, g, law, reference);
  return run;
}

} // namespace mdm
