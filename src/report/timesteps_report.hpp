#pragma once
/// \file
/// A sample over time against its gradation, as text, JSON and CSV.

#include "report/verification.hpp"
namespace mdm {

/// What is told of a sample at one timestep.
struct TimestepState {
  Integer timestep;
  Verdict verdict = Verdict::undecided;
  std::string headline;         ///< the verdict in words
  Integer particles;            ///< all
  Integer below, above;         ///< of these outside all classes
  Integer finest;               ///< of these in the finest class with mass
  std::vector<Interval> shares; ///< of the classes, of the mass in them
  Interval maximum_error, total_error;
  std::optional<SphereTexture> packing;  ///< what places say, where there are some
  std::optional<Interval> hardin, einav; ///< relative breakage against the gradation, where it is defined

  // What places say; nothing where there are none, or it has no value.
  std::optional<Interval> void_ratio() const;
  std::optional<Interval> coordination() const;
  std::optional<Interval> coordination_without_rattlers() const;
  std::optional<Interval> rattlers() const; ///< a share of the particles
  std::optional<Interval> segregation() const;
};

/// The timesteps of a file, in its order.
struct TimestepsReport {
  Gradation gradation; ///< as asked
  std::string sample;  ///< name
  unsigned digits = 6; ///< significant digits of percents
  std::vector<TimestepState> states = {};
  std::vector<std::string> notes = {};

  /// That of all together: no match where one timestep has none.
  Verdict verdict() const;
  /// Particles of the finest class with mass that the first timestep had and this one has not, as a share of
  /// those of the first; below 0 where there are more now. Nothing if the first had none.
  std::optional<Rational> fines_lost(const TimestepState &state) const;
};

/// A row a timestep. Percents are cut to `digits` significant digits; what is not known so well is a range
/// [lo, hi]; what is not available is empty.
std::string timesteps_csv(const TimestepsReport &r);
/// One line of JSON, schema `mdm-timesteps-1`, without a newline at its end.
std::string timesteps_json(const TimestepsReport &r);
/// For people.
std::string timesteps_text(const TimestepsReport &r);

} // namespace mdm
