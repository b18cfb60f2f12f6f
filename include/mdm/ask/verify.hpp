#pragma once
/// \file
/// Whether a sample matches a gradation.

#include <mdm/match/question.hpp>
#include <mdm/number/interval.hpp>

#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace mdm {

/// A class of the gradation, with what a sample has in it.
struct VerifiedClass {
  RootSize lower, upper; ///< of the sizes (lower, upper]
  Integer quantity;      ///< of particles
  Rational target;       ///< its share of the gradation's mass
  Interval share;        ///< its share of the sample's mass; a point where that is a fraction
};

/// The verdict on a sample.
struct SampleVerdict {
  /// No particle lies outside all classes, none has its centre outside the box that its file states, and
  /// every share is within the tolerance and the band. Nothing where a share is known by bounds that do not
  /// tell.
  std::optional<bool> is_match;
  Integer particles; ///< of the sample
  Integer outside;   ///< of these, in no class
  Interval error;    ///< the largest |target - share| of a class, of 1
  std::vector<VerifiedClass> classes;
  std::string json; ///< one line, schema `mdm-verify-1`
  std::string text; ///< the report for people, as `mdm verify` prints it
};

/// Judges one sample, whose particles it is given one after the other. Decimals are judged as they are
/// written, doubles as the numbers that they are. Memory: that of the classes. One thread at a time.
class SampleVerifier {
public:
  /// \param g  as it was read
  /// \param asked  its law, pan, cut, size factor, tolerances and band; without a tolerance shares are to be
  /// exact. Its floors, volume and numbers of particles are not judged
  /// Cost: the least match of the gradation, for the report: some seconds at most.
  /// \throws InputError if the question does not fit the gradation
  explicit SampleVerifier(const Gradation &g, const Question &asked = {});

  /// Adds particles of one size.
  /// \param size  diameter > 0, in the gradation's unit
  /// \throws InputError if the size is not above 0 or the quantity is less than 1
  void add(const Rational &size, const Integer &quantity = 1);

  /// Adds the particles of a text file, of any format that `mdm verify` tells by its content: dumps and data
  /// files of DEM codes, VTK, CSV with a column of sizes. Of several timesteps the last counts, and what was
  /// added before is forgotten.
  /// \param file  its name in messages
  /// \param unit  of its lengths. Open: as the file says, m in those of LAMMPS, LIGGGHTS and VTK, else the
  /// gradation's
  /// \throws InputError `file:line: what is wrong and what to do`
  void read(std::istream &particles, const std::string &file, std::optional<SizeUnit> unit = std::nullopt);

  /// The verdict on all that was added.
  /// \param name  of the sample, in the report
  SampleVerdict verdict(const std::string &name = "the sample") const;

private:
  struct State;
  std::shared_ptr<State> state_;
};

} // namespace mdm
