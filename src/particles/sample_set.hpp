#pragma once
/// \file
/// The particles of a file as they are written into files of other formats.

#include "particles/particle_reader.hpp"
#include "particles/particle_set.hpp"

#include <map>

namespace mdm {

/// Gathers particles of any sizes, as one class: numbers are written that lie in the range of their size, or
/// for a size that is known, whose mass is within the options' error. Memory: some 300 bytes a size.
class SampleSet : public ParticleSink {
public:
  void restart() override { sizes_.clear(); }
  /// \throws InputError if there are more than most_sizes
  void add(const RootSize &diameter, const Integer &quantity) override;
  /// \throws InputError as above
  void add(const SizeRange &diameter, const Integer &quantity) override;

  /// The set. \param from  the unit that the reader handed on
  /// \throws InputError if a size has no double close enough to it, or there are no particles
  ParticleSet set(const std::string &name, SizeUnit from, const ParticleSetOptions &options) const;

private:
  std::map<std::pair<Rational, Rational>, Integer> sizes_; ///< lo and hi, ascending
};

} // namespace mdm
