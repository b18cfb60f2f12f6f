#pragma once
/// \file
/// Whole counts at one mass, in double precision.

#include "match/share_program.hpp"

namespace mdm {

/// Few particles whose shares can be within bounds on those of single classes and on what passes.
class CountWalk {
public:
  /// A particle weighs more than f and up to F. Masses of the class, and of all up to it, have these shares.
  struct Class {
    double f, F;
    ShareBand share, passing;
  };
  explicit CountWalk(std::vector<Class> classes) : classes_(std::move(classes)) {}

  /// Counts with fewer particles than `limit` and, but for rounding, a sample of that mass: the fewest of
  /// those that were kept on the way. Empty if none are found.
  /// \param least,most  bounds on the counts
  std::vector<double> counts(double mass, const std::vector<double> &least, const std::vector<double> &most,
                             double limit) const;

private:
  struct Place;
  struct Reach;
  std::vector<Reach> reaches(double mass, const std::vector<double> &least,
                             const std::vector<double> &most) const;
  std::vector<Place> next(const std::vector<Place> &places, const Reach &reach, double limit) const;

  std::vector<Class> classes_;
};

} // namespace mdm
