#pragma once
/// \file
/// A sample at each of its timesteps.

#include "ask/verifier.hpp"
#include "report/timesteps_report.hpp"
#include "soil/breakage.hpp"

namespace mdm {

/// Hands the particles of a file on to a judge, and takes down what that says at the end of each timestep.
/// Memory: what the judge needs for one timestep, and a state for each.
class Timesteps : public ParticleSink {
public:
  /// \param verifier must outlive the sink
  /// \throws InputError if the gradation is of a kind whose sizes are not fractions
  Timesteps(Verifier &verifier, const std::string &sample);

  void restart() override;
  void begin_timestep(const Integer &number) override;
  void add(const RootSize &diameter, const Integer &quantity) override;
  void add(const SizeRange &diameter, const Integer &quantity) override;
  void add_at(const SphereSample::Place &place, const Rational &unit, const RootSize &diameter) override;
  bool wants_places() const override { return verifier_.particles().wants_places(); }
  void set_box(const ParticleBox &box) override { verifier_.particles().set_box(box); }

  /// What was seen. \param read  what the reader says at the end of the last timestep
  TimestepsReport report(const ReadParticles &read);

private:
  void take_down();
  void add_notes(const std::vector<std::string> &notes);

  Verifier &verifier_;
  DescriptionSink sieved_; ///< by the sieves of the gradation, and what passes the finest of them
  GradingCurve before_;
  TimestepsReport report_;
  std::optional<Integer> timestep_; ///< that is being read
};

} // namespace mdm
