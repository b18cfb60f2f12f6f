// A match whose particles have many sizes, with exactly the mass of each class (Theorem 16). What comes in
// is a match and a seed; what goes out, for each class, are integers n_i that sum to the parts of its mass,
// each in the range that keeps particle i in the class.
//
// Masses are drawn uniform by volume, particle i of class j from number i of stream j, so that nothing need
// be kept. Their sum A is not the parts D. So all are pulled towards one end e of the class, by the factor
// |D - q e| / |A - q e|, which is at most 1: none leaves the class. Rounding is done on running sums, which
// makes the sum exact whatever is rounded.
//
// A first pass over the draws finds A, a second one hands the n_i out: memory does not grow with the
// particles.

#include "match/spread.hpp"

#include "match/mass_draw.hpp"
#include "match/problem_of.hpp"
#include "match/sizes.hpp"
#include "number/philox.hpp"
#include "text/option_name.hpp"

#include <mdm/text/error.hpp>

#include <cassert>

namespace mdm {

/// Random numbers, and the masses that they draw.
class ClassSpread::Draws {
public:
  Draws(std::uint64_t seed, std::size_t stream, MassDraw mass)
      : random_(seed), stream_(stream), mass_(std::move(mass)) {}

  Integer operator()(std::uint64_t i) const { return mass_(random_(stream_, i)); }

private:
  Philox random_;
  std::size_t stream_;
  MassDraw mass_;
};

ClassSpread::ClassSpread(const Gradation &g, std::size_t index, const MassLaw &law, std::uint64_t q,
                         const Rational &powered_mass, std::uint64_t seed)
    : gradation_(&g), index_(index), law_(law), power_(law.b * g.root()), q_(q),
      grid_(fine_grid(powered_mass)),
      draws_(std::make_shared<const Draws>(
          seed, index,
          MassDraw(g.powers()[index] == 0 ? floor_div(grid_.parts, 2 * Integer(q)) : grid_.least, grid_.most,
                   law))),
      unit_(powered_mass / Rational(power(grid_.parts, power_)) / power(g.factor(index), power_)) {
  assert(q * grid_.least <= grid_.parts && grid_.parts <= q * grid_.most);
  set_pull();
}

/// Parts that a particle can have: (n / parts)^p T^p in (f^p, F^p], and below F^p where no size can be said
/// to be the upper opening, as it is irrational.
ClassSpread::Grid ClassSpread::grid(const Rational &powered_mass, const Integer &parts) const {
  const Rational one =
      power(gradation_->factor(index_), power_) * Rational(power(parts, power_)) / powered_mass;
  const auto up_to = [&](std::size_t opening) {
    const Rational most = one * law_.powered(gradation_->powers()[opening]);
    const Integer n = floor_root(floor(most), power_);
    const bool is_irrational = gradation_->root() > 1 && !gradation_->opening(opening).fraction();
    return is_irrational && opening > index_ && power(n, power_) == most ? Integer(n - 1) : n;
  };
  return {parts, up_to(index_) + 1, up_to(index_ + 1)};
}

ClassSpread::Grid ClassSpread::fine_grid(const Rational &powered_mass) const {
  for (unsigned bits = 64;; bits *= 2) {
    Grid g = grid(powered_mass, Integer(q_) << bits);
    if (g.most - g.least >= Integer(1) << 64)
      return g;
  }
}

Integer ClassSpread::draw(std::uint64_t i) const {
  return (*draws_)(i);
}

void ClassSpread::set_pull() {
  Integer sum = 0;
  for (std::uint64_t i = 0; i < q_; ++i)
    sum += draw(i);
  down_ = sum >= grid_.parts;
  const Integer end = Integer(q_) * (down_ ? grid_.least : grid_.most);
  num_ = abs(Integer(grid_.parts - end));
  den_ = abs(Integer(sum - end));
  if (den_ == 0) // every particle is at the end, where it belongs
    num_ = den_ = 1;
}

Integer ClassSpread::Masses::next() {
  const ClassSpread &c = *class_;
  const Integer end = c.down_ ? c.least() : c.most();
  drawn_ += abs(Integer(c.draw(i_++) - end));
  const Integer given = floor_div(drawn_ * c.num_, c.den_);
  const Integer distance = given - given_;
  given_ = given;
  return c.down_ ? Integer(end + distance) : Integer(end - distance);
}

Enclosure ClassSpread::size(const Integer &n, unsigned digits) const {
  return enclose_size(*gradation_, index_, law_, law_.a * gradation_->root(),
                      numerator(unit_) * power(n, power_), denominator(unit_), digits);
}

Spread spread(const Match &m, std::uint64_t seed) {
  assert(m.sample);
  if (!m.question.law.is_power())
    throw InputError("sizes are spread under a law that is a power alone: leave out the spread, or " +
                     option("law") + " by table or sum");
  if (*m.particles() > most_spread_particles)
    throw InputError("a spread of " + to_string(*m.particles()) + " particles: at most " +
                     std::to_string(most_spread_particles) +
                     " can be listed; ask for fewer, or for no spread");
  Spread result{seed, {}};
  const std::vector<Rational> masses = powered_masses(m);
  for (std::size_t j = 0; j < masses.size(); ++j)
    if (const Integer &q = m.sample->quantities[j]; q > 0)
      result.classes.emplace_back(m.gradation, j, m.question.law, static_cast<std::uint64_t>(q), masses[j],
                                  seed);
  return result;
}

} // namespace mdm
