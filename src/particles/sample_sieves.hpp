#pragma once
/// \file
/// A sample of particles as its own gradation.

#include "particles/particle_reader.hpp"

#include <mdm/gradation/gradation.hpp>

#include <map>

namespace mdm {

/// What the classes of a sample's gradation are.
enum class SampleClasses {
  between_sizes, ///< from one size to the next
  at_sizes       ///< from 10^-12 of a size, or of the lower end of a range, below it to it: what passes is
                 ///< the same from one size to the next
};

/// Gathers spheres by size: the gradation of a sample with a sieve of every size that it has. Where there are
/// more than most_sieves sizes they are rounded up, to 4 significant digits or fewer; masses stay those of
/// the sizes, and classes are between sizes. The mass of a range is that of its upper end.
class SampleSieves : public ParticleSink {
public:
  static constexpr std::size_t most_sieves = 1000;

  void restart() override;
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;

  Integer particles() const { return particles_; }
  /// Sizes, in the unit that the reader hands on, and the mass of each, x^3 for a sphere, ascending.
  const std::map<Rational, Rational> &masses() const { return masses_; }
  /// The gradation, from a pan at 0 on; its notes are those of the reader and what was done.
  /// \throws InputError if there was no particle
  Gradation gradation(const std::string &id, SizeUnit unit, std::vector<std::string> notes,
                      SampleClasses classes) const;

private:
  void gather(const Rational &least, const Rational &size, const Integer &quantity);
  void coarsen();

  std::map<Rational, Rational> masses_;
  std::map<Rational, Rational> least_; ///< of what is gathered at a size, the least lower end
  Integer particles_ = 0;
  unsigned digits_ = 0; ///< of sizes; 0: all
  bool has_ranges_ = false;
};

} // namespace mdm
