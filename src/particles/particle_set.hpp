#pragma once
/// \file
/// The particles of a match as they are written into files.

#include "gradation/share_errors.hpp"
#include "particles/particle_format.hpp"
#include "particles/written_number.hpp"

#include <mdm/match/match.hpp>

namespace mdm {

/// The most sizes that a set can hold; they take some 200 bytes each.
inline constexpr std::uint64_t most_sizes = 10000000;

/// Particles of one size. Formats have diameters or radii, and half of a short decimal need not be one, nor
/// half of its double be in the class: each is a number of its own.
struct ParticleSize {
  WrittenNumber diameter, radius;
  Integer quantity; ///< 1 or more
};

/// The particles of a class. Twice a radius and a diameter are above `lower` and up to `upper`, as decimals
/// and as doubles.
struct ParticleClass {
  std::size_t number = 0;          ///< of the gradation, from 1
  std::string material;            ///< of a gradation of several; else empty
  Rational lower, upper;           ///< in the unit of the set; irrational ones a hair inside the class
  Rational density;                ///< in kg per cube of the unit of the set
  std::vector<ParticleSize> sizes; ///< ascending but for their rounding, one or more
  Rational mass_error; ///< greatest relative error of the mass of any of them, as decimal or double

  Integer quantity() const;
  /// `class 3 (0.1, 0.2]`, and ` of quartz` where it has a material.
  std::string text() const;
};

/// The particles of a match as they are written to files.
struct ParticleSet {
  std::string name; ///< of the gradation
  SizeUnit unit = SizeUnit::m;
  MassLaw law;                        ///< of sizes in the unit
  std::vector<ParticleClass> classes; ///< those with particles, ascending by their sizes
  ShareErrors errors = {};            ///< of its shares of the mass, by what was asked for

  bool has_materials() const { return !classes.front().material.empty(); }
  Integer particles() const;
  /// The greatest of the classes: the mass of each is off by no more than this part of itself.
  Rational mass_error() const;
  /// A length in the unit of the set, which it names: 6 digits.
  std::string length_text(const Rational &length) const;
  const ParticleSize &smallest() const { return classes.front().sizes.front(); }
  const ParticleSize &largest() const { return classes.back().sizes.back(); }
  /// (pi / 6) sum of q x^3, over pi / 6: with the doubles of the diameters.
  Rational cubes() const;
  /// The same with those of the radii.
  Rational cubes_of_radii() const;
  /// (pi / 4) sum of q x^2, over pi / 4: with the doubles of the diameters, and with those of the radii.
  Rational squares() const;
  Rational squares_of_radii() const;
};

/// The way particles are written.
struct ParticleSetOptions {
  SizeUnit unit = SizeUnit::m;
  Rational density = 2650;                         ///< kg/m^3; the factor of a class multiplies it
  Rational most_mass_error = ratio(1, 1000000000); ///< relative, of each class
  bool has_floats = false;                         ///< sizes are read as floats, not as doubles
};

/// The particles of a match, which may be one of several materials.
/// \pre m.sample
/// \throws InputError if a class has no double, or float, close enough to its size
ParticleSet particle_set(const Match &m, const ParticleSetOptions &options = {});

/// The particles of the match's spread with that seed, each with a size of its own; the mass of each is as
/// close to the exact one as the options say. Cost: some 20 us a particle.
/// \throws InputError as above, or if there are more than most_sizes
ParticleSet spread_particle_set(const Match &m, std::uint64_t seed, const ParticleSetOptions &options = {});

/// Particles of one size a class.
struct SizedSample {
  /// A class with particles.
  struct Class {
    std::size_t number; ///< of the gradation, from 1
    RootSize lower, upper;
    Rational powered; ///< x^(a root) of the size x, which is in the class
    Integer quantity; ///< 1 or more
  };

  std::string name;
  SizeUnit unit = SizeUnit::mm;
  unsigned root = 1;          ///< of the gradation
  std::vector<Class> classes; ///< ascending
  ShareErrors errors = {};    ///< as in ParticleSet
};

/// The particles of a sample. \throws InputError as above
ParticleSet particle_set(const SizedSample &sample, const MassLaw &law,
                         const ParticleSetOptions &options = {});

} // namespace mdm
