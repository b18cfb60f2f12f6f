#include "match/problem.hpp"
#include "number/common_denominator.hpp"
#include "number/pi.hpp"

#include <mdm/match/match.hpp>

namespace mdm {
namespace {

/// sum of share_j / c_j: what the mass of a sample is divided by for its volume.
Rational weight_of(const Match &m) {
  const Gradation &g = m.gradation;
  if (!g.has_factors())
    return 1;
  const std::vector<Rational> all = m.sample->shares.value_or(shares(g));
  std::vector<Rational> weights;
  for (std::size_t j = 0; j < all.size(); ++j)
    weights.push_back(all[j] / g.factor(j));
  return sum(weights);
}

} // namespace

std::optional<Integer> Match::particles() const {
  return sample ? std::optional(total(sample->quantities)) : std::nullopt;
}

std::vector<MatchClass> Match::classes() const {
  std::vector<MatchClass> all;
  if (!sample)
    return all;
  std::vector<Rational> share = sample->shares.value_or(shares(gradation));
  for (std::size_t j = 0; j < gradation.classes(); ++j)
    all.push_back({gradation.opening(j), gradation.opening(j + 1), gradation.mass(j), std::move(share[j]),
                   sample->quantities[j], sample->sizes[j]});
  return all;
}

std::optional<Enclosure> Match::solids_volume() const {
  if (!sample || !question.law.is_sphere())
    return std::nullopt;
  thread_local Enclosure pi = enclose_pi(40);
  if (digits + 10 > pi.places)
    pi = enclose_pi(digits + 10);
  const Rational weight = weight_of(*this);
  const Rational &mass = sample->mass;
  if (gradation.root() > 1) { // mass = M^d
    const Enclosure M = enclose_root(numerator(mass), denominator(mass), gradation.root(), digits + 10);
    const Integer n = numerator(weight), d = denominator(weight) * 6 * power_of_ten(pi.places + M.places);
    return enclose_interval(n * pi.lo * M.lo, n * pi.hi * M.hi, d, digits);
  }
  const Rational volume = mass * weight;
  const Integer n = numerator(volume), d = denominator(volume) * 6 * power_of_ten(pi.places);
  return enclose_interval(n * pi.lo, n * pi.hi, d, digits);
}

} // namespace mdm
