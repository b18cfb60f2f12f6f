#pragma once
/// \file
/// Whole counts at one mass, or in a window of it, in double precision.

#include "match/window_relaxation.hpp"

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

  /// Counts with fewer particles than `limit` that a sample of a mass in the window could have, but for
  /// rounding, if its mass could be another one for each sieve: the fewest of those that were kept on the
  /// way. Empty if none are found.
  std::vector<double> counts(const NearWindow &window, double limit) const;

private:
  struct Place;
  struct Reach;
  std::vector<Reach> reaches(const NearWindow &window) const;
  std::vector<Place> next(const std::vector<Place> &places, const Reach &reach, double limit) const;

  std::vector<Class> classes_;
};

} // namespace mdm
