#pragma once
/// \file
/// The places of the particles of a file.

#include "packing/sphere_sample.hpp"
#include "particles/container.hpp"
#include "particles/particle_reader.hpp"

#include <mdm/gradation/gradation.hpp>

#include <functional>

namespace mdm {

/// The space of particles in a file that has this box, or none.
using SpaceOf = std::function<SampleSpace(const std::optional<ParticleBox> &)>;

/// Its box, with its top.
SampleSpace space_of_file(const std::optional<ParticleBox> &box);

/// Keeps the places of particles, grouped by the classes of a gradation, counts those outside their space,
/// and hands the particles on.
class PlacedSink : public ParticleSink {
public:
  /// \param next must outlive the sink
  /// \param most places that are kept, of more none are, and odd ones are no places; open: all are kept, and
  /// odd ones are refused
  /// \param space  which must not throw
  PlacedSink(const Gradation &g, ParticleSink &next, std::optional<std::size_t> most = std::nullopt,
             SpaceOf space = space_of_file);

  void restart() override;
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return !has_too_many_ || container_; }
  void set_box(const ParticleBox &box) override;

  /// \throws InputError if some particles have no place
  const SphereSample &sample() const;
  /// True if all particles have places, which were kept.
  bool has_all() const { return !lacks_places_ && !has_too_many_ && sample_.size() > 0; }
  bool has_too_many() const { return has_too_many_; }
  /// Why a place was not kept; empty if all that could be were.
  const std::string &odd() const { return odd_; }
  const std::optional<ParticleBox> &box() const { return box_; }
  /// What is against the sample if centres lie outside its space; nothing if none does.
  /// \param periodic  the option that says that the space is periodic
  std::optional<std::string> objection(const char *periodic) const;

private:
  void keep(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter);
  std::uint32_t class_of(const Rational &diameter) const;
  void update_container();

  std::vector<RootSize> openings_;
  ParticleSink &next_;
  SphereSample sample_;
  std::optional<ParticleBox> box_;
  std::optional<std::size_t> most_;
  SpaceOf space_;
  std::optional<Container> container_; ///< none: the space is not stated
  std::uint64_t outside_ = 0;
  std::string first_outside_, odd_;
  bool lacks_places_ = false, has_too_many_ = false;
};

} // namespace mdm
