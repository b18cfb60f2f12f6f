#pragma once
/// \file
/// A solved match with particles of many sizes.

#include <mdm/match/match.hpp>

#include <memory>

namespace mdm {

/// The particles of one class of a match, spread over the sizes of the class, with exactly the class's mass
/// together (proofs/README.md, Theorem 16).
///
/// Masses are counted in parts, 1 / parts() of the mass of the class: particle i has n_i of them, an integer,
/// and the n_i sum to parts(). They are drawn uniform by volume in the class, or, where it begins
/// at size 0, from half the mean mass on: there almost all would be dust. Then all are pulled towards one end
/// of the class, those farther away more, so that the sum is right. Particle i of class j takes number i of
/// stream j of Philox with the key `seed`.
class ClassSpread {
public:
  /// q >= 1 particles of the mass T in class `index` of g, which must outlive this; T^p = `powered_mass`, p =
  /// b times the root of g. Cost: q draws, which masses() repeats; memory does not grow with q.
  /// \pre q f < T <= q F, and T < q F where the upper opening is irrational
  ClassSpread(const Gradation &g, std::size_t index, const MassLaw &law, std::uint64_t q,
              const Rational &powered_mass, std::uint64_t seed);

  std::size_t index() const { return index_; }
  std::uint64_t quantity() const { return q_; }
  /// A multiple of q; so large that the class is 2^64 parts wide or wider for one particle.
  const Integer &parts() const { return grid_.parts; }
  /// The parts that a particle in the class can have.
  const Integer &least() const { return grid_.least; }
  const Integer &most() const { return grid_.most; }

  /// Gives the parts of the particles, one after the other.
  class Masses {
  public:
    explicit Masses(const ClassSpread &c) : class_(&c) {}
    /// The parts of the next particle; to be called quantity() times.
    Integer next();

  private:
    const ClassSpread *class_;
    std::uint64_t i_ = 0;
    Integer drawn_ = 0, given_ = 0; ///< sums of distances from the end before and behind the pull
  };
  Masses masses() const { return Masses(*this); }

  /// Encloses the size of a particle with n parts, inside the class: as enclose_size.
  Enclosure size(const Integer &n, unsigned digits) const;

private:
  struct Grid {
    Integer parts, least, most;
  };
  Grid grid(const Rational &powered_mass, const Integer &parts) const;
  Grid fine_grid(const Rational &powered_mass) const;
  Integer draw(std::uint64_t i) const;
  void set_pull();

  const Gradation *gradation_;
  std::size_t index_;
  MassLaw law_;
  unsigned power_; ///< p
  std::uint64_t q_;
  Grid grid_;
  class Draws;
  std::shared_ptr<const Draws> draws_; ///< of the parts, before the pull
  Rational unit_;                      ///< x^(a d) of a particle with one part
  bool down_ = true;                   ///< pulled towards the lower end, else the upper one
  Integer num_, den_;                  ///< a distance from that end becomes num / den <= 1 of it
};

/// The most particles that are spread.
inline constexpr std::uint64_t most_spread_particles = 1000000000;

/// The particles of the match: classes that have some, ascending.
struct Spread {
  std::uint64_t seed = 0;
  std::vector<ClassSpread> classes;
};

/// Spreads the particles of a match, which must outlive the result.
/// \pre m.sample
/// \throws InputError if they are more than most_spread_particles
Spread spread(const Match &m, std::uint64_t seed);

} // namespace mdm
