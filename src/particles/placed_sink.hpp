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
  PlacedSink(const Gradation &g, ParticleSink &next);

  void restart() override;
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return true; }
  void set_box(const ParticleBox &box) override { box_ = box; }

  /// \throws InputError if some particles have no place
  const SphereSample &sample() const;
  const std::optional<ParticleBox> &box() const { return box_; }

private:
  std::uint32_t class_of(const Rational &diameter) const;

  std::vector<RootSize> openings_;
  ParticleSink &next_;
  SphereSample sample_;
  std::optional<ParticleBox> box_;
  bool lacks_places_ = false;
};

} // namespace mdm
