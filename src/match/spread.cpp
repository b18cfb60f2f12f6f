#include <mdm/error.hpp>
#include <mdm/match/spread.hpp>

namespace mdm {

ClassSpread::ClassSpread(const Gradation &g, std::size_t index, const MassLaw &law, std::uint64_t q,
                         const Rational &powered_mass, std::uint64_t seed)
    : gradation_(&g), index_(index), law_(law), q_(q), philox_(seed), grid_(fine_grid(powered_mass)),
      draw_(g.lower(index) == 0 ? floor_div(grid_.parts, 2 * Integer(q)) : grid_.least, grid_.most, law),
      unit_(powered_mass / Rational(power(grid_.parts, law.b)) / power(g.factor(index), law.b)) {
  set_pull();
}

/// Parts that a particle can have: (n / parts)^b T^b in (f^b, F^b].
ClassSpread::Grid ClassSpread::grid(const Rational &powered_mass, const Integer &parts) const {
  const Rational one =
      power(gradation_->factor(index_), law_.b) * Rational(power(parts, law_.b)) / powered_mass;
  const auto up_to = [&](const Rational &size) {
    return floor_root(floor(Rational(one * law_.powered(size))), law_.b);
  };
  return {parts, up_to(gradation_->lower(index_)) + 1, up_to(gradation_->upper(index_))};
}

ClassSpread::Grid ClassSpread::fine_grid(const Rational &powered_mass) const {
  for (unsigned bits = 64;; bits *= 2) {
    Grid g = grid(powered_mass, Integer(q_) << bits);
    if (g.most - g.least >= Integer(1) << 64)
      return g;
  }
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
  return enclose_size(*gradation_, index_, law_, numerator(unit_) * power(n, law_.b), denominator(unit_),
                      digits);
}

Spread spread(const Match &m, std::uint64_t seed) {
  if (m.particles() > most_spread_particles)
    throw InputError("a spread of " + to_string(m.particles()) + " particles: at most " +
                     std::to_string(most_spread_particles) +
                     " can be listed; ask for fewer, or for no spread");
  Spread result{seed, {}};
  const auto add = [&](std::size_t index, const Integer &q, const Rational &powered_mass) {
    if (q > 0)
      result.classes.emplace_back(m.gradation, index, m.question.law, static_cast<std::uint64_t>(q),
                                  powered_mass, seed);
  };
  const unsigned b = m.question.law.b;
  if (m.tolerant) {
    const TolerantMatch &best = *m.tolerant->found.best;
    for (std::size_t j = 0; j < best.q.size(); ++j)
      add(j, best.q[j], power(Rational(best.t[j] / m.tolerant->problem.unit()), b));
    return result;
  }
  for (std::size_t i = 0; i < m.q.size(); ++i) {
    const std::size_t index = m.problem.classes()[i].index;
    add(index, m.q[i], m.scale * power(m.gradation.mass(index), b));
  }
  return result;
}

} // namespace mdm
