#include "../gradation/message.hpp"

#include <mdm/match/spread.hpp>
#include <mdm/number/decimal.hpp>
#include <mdm/particles/particle_set.hpp>

#include <fmt/core.h>

#include <algorithm>

namespace mdm {
namespace {

/// Writes sizes of one gradation.
class Writer {
public:
  Writer(LengthUnit from, const MassLaw &law, const ParticleSetOptions &options)
      : options_(options), law_(law), unit_(in_mm(from) / in_mm(options.unit)),
        density_(options.density * power(Rational(in_mm(options.unit) / 1000), 3)) {}

  /// A class without particles.
  ParticleClass empty(std::size_t number, const Rational &lower, const Rational &upper,
                      const Rational &factor) const {
    return {number, lower * unit_, upper * unit_, density_ * factor, {}, 0};
  }

  /// \param powered  x^a in the unit of the gradation
  void add(ParticleClass &c, const Rational &powered, const Integer &quantity) const {
    const SizeToWrite diameter{powered * power(unit_, law_.a), law_.a, c.lower, c.upper,
                               options_.most_mass_error};
    const SizeToWrite radius{diameter.powered / power(Rational(2), law_.a), law_.a, c.lower / 2, c.upper / 2,
                             options_.most_mass_error};
    c.sizes.push_back({number(c, diameter), number(c, radius), quantity});
  }

private:
  WrittenNumber number(ParticleClass &c, const SizeToWrite &size) const {
    std::optional<WrittenNumber> n = shortest_number(size);
    if (!n)
      throw InputError(fmt::format("class {}, ({}, {}] {}: no double is in it whose mass is within {} of the "
                                   "exact one: allow a larger "
                                   "--mass-error, or take another --unit or --scale",
                                   c.number, shown(c.lower), shown(c.upper), name(options_.unit),
                                   approximate(options_.most_mass_error, 3)));
    c.mass_error = std::max({c.mass_error, size.error(n->decimal()), size.error(exact_value(n->value))});
    return *std::move(n);
  }

  const ParticleSetOptions &options_;
  MassLaw law_;
  Rational unit_;
  Rational density_;
};

/// The particles of one class of a match, of which all together have the mass T.
struct ClassMass {
  std::size_t index;
  Integer quantity;
  Rational powered; ///< T^b
};

/// The classes that have particles, ascending.
std::vector<ClassMass> class_masses(const Match &m) {
  const unsigned b = m.question.law.b;
  std::vector<ClassMass> classes;
  if (m.tolerant) {
    const TolerantMatch &best = *m.tolerant->found.best;
    for (std::size_t j = 0; j < best.q.size(); ++j)
      if (best.q[j] > 0)
        classes.push_back({j, best.q[j], power(Rational(best.t[j] / m.tolerant->problem.unit()), b)});
    return classes;
  }
  for (std::size_t i = 0; i < m.q.size(); ++i) {
    const std::size_t j = m.problem.classes()[i].index;
    classes.push_back({j, m.q[i], m.scale * power(m.gradation.mass(j), b)});
  }
  return classes;
}

Rational share_error(const Match &m) {
  Rational most = 0;
  if (!m.tolerant)
    return most;
  const std::vector<Rational> asked = shares(m.gradation), &achieved = m.tolerant->shares;
  for (std::size_t j = 0; j < asked.size(); ++j)
    most = std::max(most, abs(Rational(achieved[j] - asked[j])));
  return most;
}

/// A set whose classes are filled by fill(class, what it has, x^a of a particle that had all of T).
template <class Fill>
ParticleSet match_set(const Match &m, const Writer &writer, LengthUnit unit, Fill fill) {
  const Gradation &g = m.gradation;
  ParticleSet set{g.id(), unit, m.question.law, {}, share_error(m)};
  for (const ClassMass &mass : class_masses(m)) {
    const std::size_t j = mass.index;
    set.classes.push_back(writer.empty(j + 1, g.lower(j), g.upper(j), g.factor(j)));
    fill(set.classes.back(), mass, Rational(mass.powered / power(g.factor(j), m.question.law.b)));
  }
  return set;
}

template <class Diameter>
Rational sum_of_cubes(const ParticleSet &set, Diameter diameter) {
  Rational sum = 0;
  for (const ParticleClass &c : set.classes)
    for (const ParticleSize &size : c.sizes)
      sum += Rational(size.quantity) * power(diameter(size), 3);
  return sum;
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
  return sum_of_cubes(*this, [](const ParticleSize &size) { return exact_value(size.diameter.value); });
}

Rational ParticleSet::cubes_of_radii() const {
  return sum_of_cubes(*this,
                      [](const ParticleSize &size) { return Rational(2 * exact_value(size.radius.value)); });
}

ParticleSet particle_set(const Match &m, const ParticleSetOptions &options) {
  const MassLaw &law = m.question.law;
  const Writer writer(length_unit(m.gradation.unit()), law, options);
  return match_set(m, writer, options.unit,
                   [&](ParticleClass &c, const ClassMass &mass, const Rational &powered) {
                     writer.add(c, Rational(powered / power(Rational(mass.quantity), law.b)), mass.quantity);
                   });
}

ParticleSet spread_particle_set(const Match &m, std::uint64_t seed, const ParticleSetOptions &options) {
  if (m.particles() > most_sizes)
    throw InputError(
        fmt::format("{} particles are more than the {} that can have a size each: leave --spread "
                    "out, or ask for fewer",
                    to_string(m.particles()), most_sizes));
  const MassLaw &law = m.question.law;
  const Writer writer(length_unit(m.gradation.unit()), law, options);
  const Spread spread = mdm::spread(m, seed);
  auto of_class = spread.classes.begin();
  return match_set(m, writer, options.unit,
                   [&](ParticleClass &c, const ClassMass &, const Rational &powered) {
                     std::vector<Integer> parts(of_class->quantity());
                     ClassSpread::Masses masses = of_class->masses();
                     std::generate(parts.begin(), parts.end(), [&masses] { return masses.next(); });
                     std::sort(parts.begin(), parts.end());
                     const Rational one = powered / power(Rational(of_class->parts()), law.b);
                     c.sizes.reserve(parts.size());
                     for (const Integer &n : parts)
                       writer.add(c, Rational(one * power(n, law.b)), 1);
                     ++of_class;
                   });
}

ParticleSet particle_set(const AnswerSample &answer, const MassLaw &law, const ParticleSetOptions &options) {
  if (answer.scale_power != law.b)
    throw InputError(fmt::format("the answer was made with a law x^(a/{}), not x^({}): say which with --law",
                                 answer.scale_power, law.exponent()));
  if (answer.has_spread)
    throw InputError(
        "the answer has a spread of sizes, which are rounded: export the gradation with --spread "
        "and the same --seed");
  const Writer writer(length_unit(answer.unit), law, options);
  const Rational unit = in_mm(length_unit(answer.unit)) / in_mm(options.unit);
  ParticleSet set{answer.id, options.unit, law, {}, answer.share_error};
  for (const AnswerSample::Class &c : answer.classes) {
    const Rational powered = answer.scale * power(Rational(c.mass / c.quantity), law.b);
    if (powered < power(c.size_lo, law.a) || powered > power(c.size_hi, law.a))
      throw InputError(fmt::format("scale, mass and quantity do not give the size in class {} of the answer "
                                   "with the law x^({}): say which with --law, or export the gradation "
                                   "itself if it has factors",
                                   c.number, law.exponent()));
    if (c.lower < 0 || (!set.classes.empty() && c.lower * unit < set.classes.back().upper))
      throw InputError(
          fmt::format("class {} of the answer does not begin at or above the end of those before "
                      "it: solve again",
                      c.number));
    if (powered <= power(c.lower, law.a) || powered > power(c.upper, law.a))
      throw InputError(
          fmt::format("the size in class {} of the answer is not in the class: solve again", c.number));
    set.classes.push_back(writer.empty(c.number, c.lower, c.upper, 1));
    writer.add(set.classes.back(), powered, c.quantity);
  }
  if (set.particles() != answer.particles)
    throw InputError(fmt::format("the answer says that it has {} particles, its classes have {}: solve again",
                                 to_string(answer.particles), to_string(set.particles())));
  return set;
}

} // namespace mdm
