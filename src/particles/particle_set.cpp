#include "particles/particle_set.hpp"

#include "gradation/shown.hpp"
#include "match/problem_of.hpp"
#include "match/spread.hpp"
#include "text/option_name.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

namespace mdm {
namespace {

/// Writes sizes of one gradation.
class Writer {
public:
  /// \param root  of the gradation
  Writer(SizeUnit from, const MassLaw &law, unsigned root, const ParticleSetOptions &options)
      : options_(options), degree_(law.a * root), unit_(in_mm(from) / in_mm(options.unit)),
        law_(law.scaled(unit_)), law_of_radius_(law.scaled(Rational(unit_ / 2))),
        density_(options.density * power(Rational(in_mm(options.unit) / 1000), 3)) {}

  /// A class without particles. An irrational opening becomes a fraction next to it, on the side of the
  /// class: what lies between the fractions lies in the class.
  ParticleClass empty(std::size_t number, const std::string &material, const RootSize &lower,
                      const RootSize &upper, const Rational &factor) const {
    return {number, material, bounds(lower).hi * unit_, bounds(upper).lo * unit_, density_ * factor, {}, 0};
  }

  /// The law of sizes in the unit that is written.
  const MassLaw &law() const { return law_; }

  /// \param powered  x^(a root) in the unit of the gradation, or f(x) under a law by table or sum
  void add(ParticleClass &c, const Rational &powered, const Integer &quantity) const {
    const bool is_power = law_.is_power();
    const SizeToWrite diameter{is_power ? powered * power(unit_, degree_) : powered,
                               degree_,
                               c.lower,
                               c.upper,
                               options_.most_mass_error,
                               options_.has_floats,
                               law_};
    const SizeToWrite radius{is_power ? diameter.powered / power(Rational(2), degree_) : powered,
                             degree_,
                             c.lower / 2,
                             c.upper / 2,
                             options_.most_mass_error,
                             options_.has_floats,
                             law_of_radius_};
    c.sizes.push_back({number(c, diameter), number(c, radius), quantity});
  }

private:
  WrittenNumber number(ParticleClass &c, const SizeToWrite &size) const {
    std::optional<WrittenNumber> n = shortest_number(size);
    if (!n)
      throw InputError(fmt::format("class {}, ({}, {}] {}: no {} is in it whose mass is within {} of the "
                                   "exact one: allow a larger "
                                   "{}, or take another {} or {}",
                                   c.number, shown(c.lower), shown(c.upper), name(options_.unit),
                                   options_.has_floats ? "float" : "double",
                                   approximate(options_.most_mass_error, 3), option("mass-error"),
                                   option("unit"), option("scale")));
    c.mass_error = std::max({c.mass_error, size.error(n->decimal()), size.error(exact_value(n->value))});
    return *std::move(n);
  }

  const ParticleSetOptions &options_;
  unsigned degree_; ///< a root
  Rational unit_;
  MassLaw law_, law_of_radius_; ///< in the unit that is written
  Rational density_;
};

ShareErrors errors_of(const Match &m) {
  return m.sample->shares ? share_errors(shares(m.gradation), *m.sample->shares) : ShareErrors{};
}

/// A set whose classes are filled by fill(class, its quantity, x^(a root) of a particle that had all of its
/// mass).
template <class Fill>
ParticleSet match_set(const Match &m, const Writer &writer, SizeUnit unit, Fill fill) {
  const Gradation &g = m.gradation;
  ParticleSet set{g.id(), unit, writer.law(), {}, errors_of(m)};
  const std::vector<Rational> masses = powered_masses(m);
  for (std::size_t j = 0; j < masses.size(); ++j) {
    const Integer &q = m.sample->quantities[j];
    if (q == 0)
      continue;
    set.classes.push_back(writer.empty(j + 1, g.material(j), g.opening(j), g.opening(j + 1), g.factor(j)));
    fill(set.classes.back(), q, Rational(masses[j] / power(g.factor(j), m.scale_power())));
  }
  // The classes of one material come behind those of another, and theirs overlap.
  std::stable_sort(set.classes.begin(), set.classes.end(),
                   [](const ParticleClass &a, const ParticleClass &b) {
                     return a.sizes.front().diameter.value < b.sizes.front().diameter.value;
                   });
  return set;
}

Rational diameter_of(const ParticleSize &size) {
  return exact_value(size.diameter.value);
}

Rational twice_radius(const ParticleSize &size) {
  return 2 * exact_value(size.radius.value);
}

Rational sum_of_powers(const ParticleSet &set, unsigned exponent,
                       Rational (*diameter)(const ParticleSize &)) {
  Rational sum = 0;
  for (const ParticleClass &c : set.classes)
    for (const ParticleSize &size : c.sizes)
      sum += Rational(size.quantity) * power(diameter(size), exponent);
  return sum;
}

} // namespace

Integer ParticleClass::quantity() const {
  Integer n = 0;
  for (const ParticleSize &size : sizes)
    n += size.quantity;
  return n;
}

std::string ParticleClass::text() const {
  return fmt::format("class {} ({}, {}]{}", number, short_decimal(lower), short_decimal(upper),
                     material.empty() ? "" : " of " + printable(material));
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

std::string ParticleSet::length_text(const Rational &length) const {
  return approximate(length, 6) + " " + std::string(mdm::name(unit));
}

Rational ParticleSet::cubes() const {
  return sum_of_powers(*this, 3, diameter_of);
}

Rational ParticleSet::cubes_of_radii() const {
  return sum_of_powers(*this, 3, twice_radius);
}

Rational ParticleSet::squares() const {
  return sum_of_powers(*this, 2, diameter_of);
}

Rational ParticleSet::squares_of_radii() const {
  return sum_of_powers(*this, 2, twice_radius);
}

ParticleSet particle_set(const Match &m, const ParticleSetOptions &options) {
  assert(m.sample);
  const Writer writer(m.gradation.unit(), m.question.law, m.gradation.root(), options);
  const unsigned p = m.scale_power();
  return match_set(m, writer, options.unit, [&](ParticleClass &c, const Integer &q, const Rational &powered) {
    writer.add(c, Rational(powered / power(Rational(q), p)), q);
  });
}

ParticleSet spread_particle_set(const Match &m, std::uint64_t seed, const ParticleSetOptions &options) {
  assert(m.sample);
  if (*m.particles() > most_sizes)
    throw InputError(fmt::format("{} particles are more than the {} that can have a size each: leave {} "
                                 "out, or ask for fewer",
                                 to_string(*m.particles()), most_sizes, option("spread")));
  const Writer writer(m.gradation.unit(), m.question.law, m.gradation.root(), options);
  const unsigned p = m.scale_power();
  const Spread spread = mdm::spread(m, seed);
  auto of_class = spread.classes.begin();
  return match_set(m, writer, options.unit, [&](ParticleClass &c, const Integer &, const Rational &powered) {
    std::vector<Integer> parts(of_class->quantity());
    ClassSpread::Masses masses = of_class->masses();
    std::generate(parts.begin(), parts.end(), [&masses] { return masses.next(); });
    std::sort(parts.begin(), parts.end());
    const Rational one = powered / power(Rational(of_class->parts()), p);
    c.sizes.reserve(parts.size());
    for (const Integer &n : parts)
      writer.add(c, Rational(one * power(n, p)), 1);
    ++of_class;
  });
}

ParticleSet particle_set(const SizedSample &sample, const MassLaw &law, const ParticleSetOptions &options) {
  const Writer writer(sample.unit, law, sample.root, options);
  ParticleSet set{sample.name, options.unit, writer.law(), {}, sample.errors};
  for (const SizedSample::Class &c : sample.classes) {
    set.classes.push_back(writer.empty(c.number, "", c.lower, c.upper, 1));
    writer.add(set.classes.back(), c.powered, c.quantity);
  }
  return set;
}

} // namespace mdm
