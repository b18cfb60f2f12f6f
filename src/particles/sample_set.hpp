#pragma once
/// \file
/// The particles of a file as they are written into files of other formats.

#include "particles/kept_places.hpp"
#include "particles/particle_reader.hpp"
#include "particles/particle_set.hpp"

#include <mdm/gradation/gradation.hpp>

#include <map>

namespace mdm {

/// Gathers particles of any sizes: numbers are written that lie in the range of their size, or
/// for a size that is known, whose mass is within the options' error. Memory: some 300 bytes a size, 100 a
/// particle with a place.
class SampleSet : public ParticleSink {
public:
  void restart() override;
  /// \throws InputError if there are more than most_sizes
  void add(const RootSize &diameter, const Integer &quantity) override;
  /// \throws InputError as above
  void add(const SizeRange &diameter, const Integer &quantity) override;
  /// \throws InputError as above
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return true; }
  void set_box(const ParticleBox &box) override { box_ = box; }

  /// The set. Its classes are those of the gradation; without one a class has sizes up to sqrt(2) times its
  /// smallest. \param from  the unit that the reader handed on
  /// \throws InputError if a size has no double close enough to it or is outside of all classes, or there are no
  /// particles
  ParticleSet set(const std::string &name, SizeUnit from, const ParticleSetOptions &options,
                  const Gradation *sieves = nullptr) const;

  /// The places, of the set that set() gave; nothing unless all particles have one.
  /// \throws InputError if a centre is outside of the box
  std::optional<KeptPlaces> places(const ParticleSet &set, SizeUnit from) const;

private:
  using Sizes = std::map<std::pair<Rational, Rational>, Integer>; ///< lo and hi, ascending
  struct Placed {
    Sizes::const_iterator size;
    std::array<Rational, 3> at;
  };

  Sizes::const_iterator gather(const SizeRange &diameter, const Integer &quantity);

  Sizes sizes_;
  std::vector<Placed> placed_;
  std::optional<ParticleBox> box_;
  bool lacks_places_ = false;
};

} // namespace mdm
