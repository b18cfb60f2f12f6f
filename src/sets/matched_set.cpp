// The smallest representative set whose class masses are exact. Bounds and shares of the classes are
// rounded to decimals, and from there on these decimals are a gradation and the set is its least match,
// with the proof of any match (Theorems 1 to 7).
//
// With room for a spread, each class is cut at two sizes so that the mean particle can be that of sizes
// uniform by volume (Theorem 16, "Room"). The match of the cut classes has the fewest particles N that
// allow it; these N are then shared out again so that the means are as near as whole numbers let them be.
// Three ways are compared, and the best is taken.

#include "sets/matched_set.hpp"

#include "match/exact_sample.hpp"
#include "number/common_denominator.hpp"
#include "sets/uniform_counts.hpp"
#include "text/option_name.hpp"

#include <mdm/match/solve.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace mdm {
namespace {

Rational decimal(const Real &y, unsigned digits) {
  try {
    return parse_decimal(rounded(y, digits));
  } catch (const InputError &) {
    throw InputError(
        fmt::format("a bound or volume of a class has no decimal of up to 1000 digits and exponent 400 to be "
                    "matched: give fewer {}, or use fewer or isochoric classes",
                    option("match-digits")));
  }
}

Question question_of(const Representativity &wanted) {
  Question question;
  question.law = MassLaw{wanted.dimension, 1};
  question.min_per_class = wanted.min_per_class;
  question.at_least = wanted.at_least;
  return question;
}

/// The sizes between which the mean particle of a class with lower bound l > 0 and upper bound u is to be,
/// rounded down: that of the mean volume, and that halfway in volume from l to it.
std::pair<Rational, Rational> room(const Rational &l, const Rational &u, unsigned dimension,
                                   unsigned digits) {
  const Rational mean = uniform_mean(l, u, dimension);
  const Rational half = (power(l, dimension) + mean) / 2;
  for (;; digits *= 2) {
    const auto size = [&](const Rational &volume) {
      return enclose_root(numerator(volume), denominator(volume), dimension, digits).lower();
    };
    if (l < size(half) && size(half) < size(mean))
      return {size(half), size(mean)};
  }
}

/// Every class that does not begin at 0 cut at both: the mass is between them.
Gradation cut_to_room(const Gradation &g, unsigned dimension, unsigned digits) {
  Gradation::Data data;
  data.id = g.id();
  const auto add = [&](const Rational &size, const Rational &mass) {
    data.sizes.push_back(size);
    data.masses.push_back(mass);
  };
  for (std::size_t j = 0; j < g.classes(); ++j) {
    if (g.mass(j) == 0 || g.lower(j) == 0) {
      add(g.lower(j), g.mass(j));
      continue;
    }
    const auto [from, to] = room(g.lower(j), g.upper(j), dimension, digits);
    add(g.lower(j), 0);
    add(from, g.mass(j));
    add(to, 0);
  }
  add(g.sizes().back(), 0);
  return Gradation(std::move(data));
}

/// Of as many particles as the match of cut classes has, those with means nearest to mu: shared out by
/// volume, or the match's own, where that goes wrong in a narrow class; these at the highest scale, where the
/// means of cut classes are nearest, or at the chosen one, which is better for a class that begins at 0.
UniformCounts nearest_counts(const Gradation &g, const Problem &problem, const Match &cut) {
  std::vector<Integer> q;
  for (const Integer &n : cut.sample->quantities)
    if (n > 0)
      q.push_back(n);
  const Rational &unit = problem.scale_unit();
  const Window window{problem.lowest_scale(q) * unit, problem.highest_scale(q) * unit, std::nullopt};
  const MatchScale &scale = *cut.sample->scale;
  std::vector<UniformCounts> all = {{q, scale.window.up_to, window}, {q, scale.chosen, window}};
  if (std::optional<UniformCounts> shared = uniform_counts(g, problem, total(q)))
    all.push_back(std::move(*shared));
  const auto farthest = [&](const UniformCounts &c) { return farthest_mean(g, problem, c.q, c.scale); };
  return *std::min_element(all.begin(), all.end(), [&](const UniformCounts &x, const UniformCounts &y) {
    return farthest(x) < farthest(y);
  });
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
                       " digits: give more with " + option("match-digits"));
    data.masses.push_back(c.is_empty() ? Rational(0) : decimal(c.volume_fraction, digits));
  }
  data.masses.emplace_back(0);
  return Gradation(std::move(data));
}

Representativity of_match(Representativity wanted, const Gradation &rounded, bool is_spread) {
  if (!wanted.largest_share)
    return wanted;
  Rational most = 1;
  for (std::size_t j = 0; is_spread && j < rounded.classes(); ++j) {
    if (rounded.mass(j) == 0)
      continue;
    if (rounded.lower(j) == 0)
      throw InputError(option("largest-share") +
                       ": a class begins at 0: there is no bound on how much smaller other "
                       "particles of it are; leave out " +
                       option("spread") + " or give the pan a size");
    most = std::max(most, power(Rational(rounded.upper(j) / rounded.lower(j)), wanted.dimension));
  }
  wanted.min_per_class = std::max(wanted.min_per_class, ceil(Rational(most / *wanted.largest_share)));
  return wanted;
}

Match matched_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options) {
  return solve(rounded, question_of(wanted), options);
}

Match roomy_set(const Gradation &rounded, const Representativity &wanted, const SolveOptions &options,
                unsigned size_digits) {
  const Match cut = solve(cut_to_room(rounded, wanted.dimension, size_digits), question_of(wanted), options);
  Match m(cut.question, rounded);
  m.status = cut.status;
  m.complete = cut.complete;
  m.lower_bound = cut.lower_bound;
  m.digits = options.digits;
  const Problem problem(rounded, m.question.law, m.question.min_per_class);
  UniformCounts counts = nearest_counts(rounded, problem, cut);
  m.notes.push_back("the mean volume of the particles of every class is within " +
                    approximate(Rational(100 * farthest_mean(rounded, problem, counts.q, counts.scale)), 3) +
                    " % of that of sizes uniform by volume");
  m.sample = exact_sample(rounded, problem, std::move(counts.q), std::move(counts.window), counts.scale,
                          options.digits);
  return m;
}

ParticlesOf matched_particles(const Match &m) {
  return [&m](std::size_t j, const TakeSize &take) {
    if (const std::optional<Enclosure> &size = m.sample->sizes[j])
      take(*size, m.sample->quantities[j]);
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
