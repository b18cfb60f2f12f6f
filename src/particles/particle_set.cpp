#include "../gradation/message.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/particles/particle_set.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Particles of one size, in the unit of their gradation.
struct SourceSize {
  std::size_t number; // of the class
  Rational lower, upper;
  Rational powered; // x^a
  Rational factor;  // of the density
  Integer quantity;
};

/// Writes sizes of one gradation.
class Writer {
public:
  Writer(LengthUnit from, const MassLaw &law, const ParticleSetOptions &options)
      : options_(options), law_(law), unit_(in_mm(from) / in_mm(options.unit)),
        density_(options.density * power(Rational(in_mm(options.unit) / 1000), 3)) {}

  ParticleClass write(const SourceSize &s) const {
    const WrittenNumber diameter = number(s, unit_);
    const WrittenNumber radius = number(s, Rational(unit_ / 2));
    return {s.number,
            s.lower * unit_,
            s.upper * unit_,
            density_ * s.factor,
            {{diameter, radius, s.quantity}},
            std::max(error(s, diameter, unit_), error(s, radius, Rational(unit_ / 2)))};
  }

private:
  SizeToWrite size(const SourceSize &s, const Rational &unit) const {
    return {s.powered * power(unit, law_.a), law_.a, s.lower * unit, s.upper * unit,
            options_.most_mass_error};
  }

  WrittenNumber number(const SourceSize &s, const Rational &unit) const {
    std::optional<WrittenNumber> n = shortest_number(size(s, unit));
    if (!n)
      throw InputError(fmt::format(
          "class {}, ({}, {}]: no double is in it whose mass is within {} of the exact one: allow a larger "
          "--mass-error, or take another --unit or --scale",
          s.number, shown(s.lower), shown(s.upper), approximate(options_.most_mass_error, 3)));
    return *std::move(n);
  }

  Rational error(const SourceSize &s, const WrittenNumber &n, const Rational &unit) const {
    const SizeToWrite to = size(s, unit);
    return std::max(to.error(n.decimal), to.error(exact_value(n.value)));
  }

  const ParticleSetOptions &options_;
  MassLaw law_;
  Rational unit_;
  Rational density_;
};

/// s (m / (q c))^b.
Rational powered_size(const Rational &scale, const Rational &mass, const Rational &factor, const Integer &q,
                      const MassLaw &law) {
  return scale * power(Rational(mass / (factor * q)), law.b);
}

} // namespace

Integer ParticleClass::quantity() const {
  Integer n = 0;
  for (const ParticleSize &size : sizes)
    n += size.quantity;
  return n;
}

Integer ParticleSet::particles() const {
  Integer n = 0;
  for (const ParticleClass &c : classes)
    n += c.quantity();
  return n;
}

Rational ParticleSet::mass_error() const {
  Rational most = 0;
  for (const ParticleClass &c : classes)
    most = std::max(most, c.mass_error);
  return most;
}

Rational ParticleSet::cubes() const {
  Rational sum = 0;
  for (const ParticleClass &c : classes)
    for (const ParticleSize &size : c.sizes)
      sum += Rational(size.quantity) * power(exact_value(size.diameter.value), 3);
  return sum;
}

ParticleSet particle_set(const Match &m, const ParticleSetOptions &options) {
  const Gradation &g = m.gradation;
  const MassLaw &law = m.question.law;
  const Writer writer(length_unit(g.unit()), law, options);
  ParticleSet set{g.id(), options.unit, law, {}};
  const auto add = [&](std::size_t j, const Rational &powered, const Integer &quantity) {
    set.classes.push_back(writer.write({j + 1, g.lower(j), g.upper(j), powered, g.factor(j), quantity}));
  };
  if (m.tolerant) {
    const TolerantMatch &best = *m.tolerant->found.best;
    for (std::size_t j = 0; j < g.classes(); ++j)
      if (best.q[j] > 0)
        add(j, powered_size(1, Rational(best.t[j] / m.tolerant->problem.unit()), g.factor(j), best.q[j], law),
            best.q[j]);
    return set;
  }
  for (std::size_t i = 0; i < m.q.size(); ++i) {
    const std::size_t j = m.problem.classes()[i].index;
    add(j, powered_size(m.scale, g.mass(j), g.factor(j), m.q[i], law), m.q[i]);
  }
  return set;
}

ParticleSet particle_set(const AnswerSample &answer, const MassLaw &law, const ParticleSetOptions &options) {
  if (answer.scale_power != law.b)
    throw InputError(fmt::format("the answer was made with a law x^(a/{}), not x^({}): say which with --law",
                                 answer.scale_power, law.exponent()));
  const Writer writer(length_unit(answer.unit), law, options);
  ParticleSet set{answer.id, options.unit, law, {}};
  for (const AnswerSample::Class &c : answer.classes) {
    const Rational powered = powered_size(answer.scale, c.mass, 1, c.quantity, law);
    if (powered < power(c.size_lo, law.a) || powered > power(c.size_hi, law.a))
      throw InputError(fmt::format("scale, mass and quantity do not give the size in class {} of the answer "
                                   "with the law x^({}): say which with --law, or export the gradation "
                                   "itself if it has factors",
                                   c.number, law.exponent()));
    if (powered <= power(c.lower, law.a) || powered > power(c.upper, law.a))
      throw InputError(
          fmt::format("the size in class {} of the answer is not in the class: solve again", c.number));
    set.classes.push_back(writer.write({c.number, c.lower, c.upper, powered, 1, c.quantity}));
  }
  if (set.particles() != answer.particles)
    throw InputError(fmt::format("the answer says that it has {} particles, its classes have {}: solve again",
                                 to_string(answer.particles), to_string(set.particles())));
  return set;
}

} // namespace mdm
