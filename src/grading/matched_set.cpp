#include <mdm/error.hpp>
#include <mdm/grading/matched_set.hpp>
#include <mdm/number/common_denominator.hpp>
#include <mdm/number/decimal.hpp>

#include <algorithm>

namespace mdm {
namespace {

Rational decimal(const Real &y, unsigned digits) {
  return parse_decimal(rounded(y, digits));
}

} // namespace

Gradation rounded_gradation(const std::vector<SizeClass> &classes, unsigned digits, const std::string &id) {
  Gradation::Data data;
  data.id = id;
  data.sizes.push_back(decimal(classes.front().lower.real, digits));
  for (const SizeClass &c : classes) {
    data.sizes.push_back(decimal(c.upper.real, digits));
    if (*(data.sizes.end() - 2) >= data.sizes.back())
      throw InputError("bounds of classes become the same with " + std::to_string(digits) +
                       " digits: give more with --match-digits");
    data.masses.push_back(c.is_empty() ? Rational(0) : decimal(c.volume_fraction, digits));
  }
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

Match matched_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options) {
  Question question;
  question.law = MassLaw{wanted.dimension, 1};
  question.min_per_class = wanted.min_per_class;
  question.at_least = wanted.at_least;
  return solve(rounded, question, options);
}

std::optional<std::size_t> place_in_match(const Match &m, std::size_t j) {
  const std::vector<ProblemClass> &classes = m.problem.classes();
  const auto at = std::find_if(classes.begin(), classes.end(), [j](const auto &c) { return c.index == j; });
  if (at == classes.end())
    return std::nullopt;
  return static_cast<std::size_t>(at - classes.begin());
}

ParticlesOf matched_particles(const Match &m) {
  return [&m](std::size_t j, const TakeSize &take) {
    if (const std::optional<std::size_t> place = place_in_match(m, j))
      take(m.sizes[*place], m.q[*place]);
  };
}

ParticlesOf spread_particles(const Match &m, std::uint64_t seed) {
  const auto all = std::make_shared<const Spread>(spread(m, seed));
  return [all, digits = m.digits](std::size_t j, const TakeSize &take) {
    const auto at = std::find_if(all->classes.begin(), all->classes.end(),
                                 [j](const ClassSpread &c) { return c.index() == j; });
    if (at == all->classes.end())
      return;
    ClassSpread::Masses masses = at->masses();
    for (std::uint64_t i = 0; i < at->quantity(); ++i)
      take(at->size(masses.next(), digits), 1);
  };
}

SetQuality matched_quality(const Match &m, const ModelCurve &curve, unsigned dimension, unsigned points,
                           const ParticlesOf &particles) {
  const Gradation &g = m.gradation;
  const Rational all = sum(g.masses());
  std::vector<SizeClass> classes;
  std::vector<Rational> shares;
  for (std::size_t j = 0; j < g.classes(); ++j) {
    shares.push_back(g.mass(j) / all);
    classes.push_back({Surd(g.lower(j)), Surd(g.upper(j)), shares.back()});
  }
  return set_quality(curve, classes, dimension, points, particles, shares);
}

} // namespace mdm
