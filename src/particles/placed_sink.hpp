#pragma once
/// \file
/// The places of the particles of a file.

#include <mdm/gradation/gradation.hpp>
#include <mdm/packing/sphere_sample.hpp>
#include <mdm/particles/particle_reader.hpp>

namespace mdm {

/// Keeps the places of particles, grouped by the classes of a gradation, and hands the particles on.
class PlacedSink : public ParticleSink {
public:
  /// \param next must outlive the sink
  /// \param most places that are kept, of more none are, and odd ones are no places; open: all are kept, and
  /// odd ones are refused
  PlacedSink(const Gradation &g, ParticleSink &next, std::optional<std::size_t> most = std::nullopt);

  void restart() override;
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return !has_too_many_; }
  void set_box(const ParticleBox &box) override { box_ = box; }

  /// \throws InputError if some particles have no place
  const SphereSample &sample() const;
  /// True if all particles have places, which were kept.
  bool has_all() const { return !lacks_places_ && !has_too_many_ && sample_.size() > 0; }
  bool has_too_many() const { return has_too_many_; }
  const std::optional<ParticleBox> &box() const { return box_; }

private:
  void keep(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter);
  std::uint32_t class_of(const Rational &diameter) const;

  std::vector<RootSize> openings_;
  ParticleSink &next_;
  SphereSample sample_;
  std::optional<ParticleBox> box_;
  std::optional<std::size_t> most_;
  bool lacks_places_ = false, has_too_many_ = false;
};

} // namespace mdm
