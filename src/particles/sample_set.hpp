#pragma once
/// \file
/// The particles of a file as they are written into files of other formats.

#include "particles/kept_places.hpp"
#include "particles/particle_reader.hpp"
#include "particles/particle_set.hpp"

#include <mdm/gradation/gradation.hpp>

#include <map>
#include <tuple>

namespace mdm {

/// Gathers particles of any sizes: numbers are written that lie in the range of their size, or
/// for a size that is known, whose mass is within the options' error. Memory: some 300 bytes a size, 100 a
/// particle with a place.
class SampleSet : public ParticleSink {
public:
  void restart() override;
  void set_material(const std::string &name) override { material_ = name; }
  void set_class(std::uint64_t number) override { class_ = number; }
  /// \throws InputError if there are more than most_sizes
  void add(const RootSize &diameter, const Integer &quantity) override;
  /// \throws InputError as above
  void add(const SizeRange &diameter, const Integer &quantity) override;
  /// \throws InputError as above
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return true; }
  void set_box(const ParticleBox &box) override { box_ = box; }

  /// The set. Its classes are those of the gradation; without one those that the particles say; else a class
  /// has sizes up to sqrt(2) times its smallest. Each is of one material.
  /// \param from  the unit that the reader handed on
  /// \throws InputError if a size has no double close enough to it or is outside of all classes, or there are no
  /// particles
  ParticleSet set(const std::string &name, SizeUnit from, const ParticleSetOptions &options,
                  const Gradation *sieves = nullptr) const;

  /// True if each particle says its class, there are several, and none has a size between those of another.
  bool has_classes() const;
  /// True if each particle says its class, but these are none of sizes.
  bool has_other_classes() const { return !lacks_classes_ && classes_.size() > 1 && !has_classes(); }

  /// The places, of the set that set() gave; nothing unless all particles have one.
  /// \throws InputError if a centre is outside of the box
  std::optional<KeptPlaces> places(const ParticleSet &set, SizeUnit from) const;

private:
  /// Particles of one material whose sizes have the same range.
  struct Size {
    std::string material; ///< empty: none is said
    Rational lo, hi;
    bool operator<(const Size &other) const {
      return std::tie(material, lo, hi) < std::tie(other.material, other.lo, other.hi);
    }
  };
  using Sizes = std::map<Size, Integer>;
  using Span = std::pair<Rational, Rational>; ///< from the least to the greatest size
  struct Placed {
    Sizes::const_iterator size;
    std::array<Rational, 3> at;
  };

  /// Bounds of classes, above the first, up to the second, and so on, and their numbers, or from 1 on.
  struct Classes {
    std::vector<Rational> openings;
    std::vector<std::uint64_t> numbers;
  };

  Classes classes(SizeUnit from, SizeUnit to, const Gradation *sieves) const;
  Sizes::const_iterator gather(const SizeRange &diameter, const Integer &quantity);
  void gather_class(const SizeRange &diameter);

  Sizes sizes_;
  std::map<std::uint64_t, Span> classes_; ///< that particles say
  std::string material_;                  ///< of the next particles
  std::optional<std::uint64_t> class_;    ///< of the next particles
  std::vector<Placed> placed_;
  std::optional<ParticleBox> box_;
  bool lacks_places_ = false, lacks_classes_ = false;
};

} // namespace mdm
