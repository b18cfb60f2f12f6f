// The masses of a line of a suite. What comes in is a kind (random, with gaps, of a beta or a lognormal
// curve, tied) and the numbers of one stream; what goes out are masses, the same on every machine.
//
// Random masses are parts of the whole between random cuts, each above 0: percentages that sum to 100
// exactly. Curves are rounded at each sieve, halves up, by refining, and the differences are the masses, so
// that these sum to 100 as well. Normal masses are heights of the bell curve, rounded by refining, with a
// random part of its height added in each class; then as curves. Ties are masses that q particles of the size
// of the lower or the upper sieve have, so that ends of classes meet at one scale: the cases in which an open
// bound decides.

#include "sets/suite_masses.hpp"

#include "sets/beta_curve.hpp"

#include <algorithm>

namespace mdm {
namespace {

/// `parts` numbers above 0 that sum to `whole`, all such equally likely.
std::vector<Integer> drawn_parts(std::size_t parts, const Integer &whole, RandomStream &random) {
  const Integer free = whole - Integer(parts);
  std::vector<Integer> cuts{0};
  for (std::size_t i = 1; i < parts; ++i)
    cuts.push_back(random.below(Integer(free + 1)));
  cuts.push_back(free);
  std::sort(cuts.begin(), cuts.end());
  std::vector<Integer> drawn;
  for (std::size_t i = 0; i < parts; ++i)
    drawn.push_back(Integer(cuts[i + 1] - cuts[i] + 1));
  return drawn;
}

/// The shares of `whole` in the classes of a curve with passing(openings[i]) at sieve i, 0 at the first and 1
/// at the last. What passes is rounded to whole numbers, halves up; what most_bits do not tell from a half
/// counts as one.
template <class Passing>
std::vector<Integer> curve_parts(std::size_t classes, const Integer &whole, const Passing &passing) {
  std::vector<Integer> parts;
  Integer below = 0;
  for (std::size_t i = 1; i <= classes; ++i) {
    const Integer up_to =
        i == classes ? whole : floor_of(passing(i) * Real(Rational(whole)) + Real(ratio(1, 2))).hi;
    parts.push_back(Integer(up_to - below));
    below = up_to;
  }
  return parts;
}

/// ln(x_i / median) / (deviation sqrt 2), of which erf is linear in what passes.
Ball lognormal_place(const Rational &x, const Rational &first, const Rational &last, const Rational &median,
                     const Rational &deviation, unsigned bits) {
  const Ball range = log(Ball(Rational(last / first), bits));
  const Ball above = log(Ball(Rational(x / first), bits)) - Ball(median, bits) * range;
  return above / (Ball(deviation, bits) * pow(Ball(2, bits), ratio(1, 2)));
}

/// Draws the masses of each kind.
struct DrawnMasses {
  const std::vector<Rational> &openings;
  const Integer whole; ///< 10^digits
  RandomStream &random;

  std::size_t classes() const { return openings.size() - 1; }

  std::vector<Rational> percentages(const std::vector<Integer> &parts) const {
    std::vector<Rational> masses;
    for (const Integer &part : parts)
      masses.push_back(ratio(Integer(100 * part), whole));
    return masses;
  }

  std::vector<Rational> operator()(const RandomMasses &) const {
    return percentages(drawn_parts(classes(), whole, random));
  }

  std::vector<Rational> operator()(const GapMasses &gap) const {
    const std::uint32_t empty = gap.empty.drawn(random);
    const std::uint32_t first = 1 + random.below(static_cast<std::uint32_t>(classes()) - 1 - empty);
    std::vector<Integer> parts = drawn_parts(classes() - empty, whole, random);
    parts.insert(parts.begin() + first, empty, Integer(0));
    return percentages(parts);
  }

  std::vector<Rational> operator()(const BetaMasses &beta) const {
    const Rational a = beta.a.drawn(random), b = beta.b.drawn(random);
    const BetaCurve curve(a, b, openings.front(), openings.back());
    return percentages(
        curve_parts(classes(), whole, [&](std::size_t i) { return curve.passing(Surd(openings[i])); }));
  }

  std::vector<Rational> operator()(const LognormalMasses &lognormal) const {
    const Rational median = lognormal.median.drawn(random), deviation = lognormal.deviation.drawn(random);
    const auto share = [&](std::size_t i, unsigned bits) {
      const auto at = [&](const Rational &x) {
        return erf(lognormal_place(x, openings.front(), openings.back(), median, deviation, bits));
      };
      const Ball least = at(openings.front());
      return (at(openings[i]) - least) / (at(openings.back()) - least);
    };
    return percentages(curve_parts(classes(), whole, [&](std::size_t i) {
      return Real([&share, i](unsigned bits) { return share(i, bits); });
    }));
  }

  std::vector<Rational> operator()(const NormalMasses &normal) const {
    const Rational centre = normal.centre.drawn(random) * classes(),
                   deviation = normal.deviation.drawn(random), noise = normal.noise.drawn(random);
    std::vector<Integer> up_to{0};
    for (std::size_t j = 0; j < classes(); ++j) {
      const Rational place = (ratio(2 * j + 1, 2) - centre) / deviation;
      const Real height([place](unsigned bits) { return exp(Ball(Rational(-place * place / 2), bits)); });
      const Integer rounded = floor_of(height * Real(Rational(whole)) + Real(ratio(1, 2))).hi;
      const Integer added = floor(Rational(noise * Rational(random.below(Integer(whole + 1)))));
      up_to.push_back(Integer(up_to.back() + rounded + added));
    }
    return percentages(
        curve_parts(classes(), whole, [&](std::size_t i) { return Real(ratio(up_to[i], up_to.back())); }));
  }

  std::vector<Rational> operator()(const TiedMasses &ties) const {
    std::vector<Rational> masses;
    for (std::size_t j = 0; j < classes(); ++j) {
      const bool at_upper =
          ties.at == TiedMasses::At::either ? random.below(2U) == 1 : ties.at == TiedMasses::At::upper;
      masses.push_back(Rational(ties.quantities.drawn(random)) *
                       power(openings[at_upper ? j + 1 : j], ties.power));
    }
    return masses;
  }
};

} // namespace

std::vector<Rational> drawn_masses(const SuiteMasses &kind, const std::vector<Rational> &openings,
                                   unsigned digits, RandomStream &random) {
  return std::visit(DrawnMasses{openings, power_of_ten(digits), random}, kind);
}

} // namespace mdm
