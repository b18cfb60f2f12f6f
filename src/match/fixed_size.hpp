#pragma once
/// \file
/// The approximate match and the fixed size algorithm as published.

#include "match/published.hpp"

namespace mdm {

/// The rounding of int() in Eq. 18.
enum class Rounding {
  nearest, ///< to the nearest integer, a half up
  even,    ///< to the nearest integer, a half to the even one
  up,
  down ///< may leave a class without particles
};

/// r >= 0 rounded.
Integer rounded(const Rational &r, Rounding rounding);

/// The settings of the fixed size algorithm.
struct FixedSizeOptions {
  SizeChoice sizes{ratio(1, 2)}; ///< of every class
  Rounding rounding = Rounding::nearest;
  Rational tolerance = ratio(1, 100); ///< on the total error
  std::uint64_t max_iterations = 999; ///< >= 1
};

/// The fixed size algorithm (FS, steps 1-5): int(i K) particles for i = 1, 2, ... until the total error is
/// within the tolerance. With max_iterations = 1 it is S_approx (Eq. 18). Sizes stay as chosen, so every
/// particle lies in its class. Cost: some fractions a class in an iteration.
/// \throws InputError if the law is not rational
Published fixed_size(const Gradation &g, const MassLaw &law, const FixedSizeOptions &options = {});

} // namespace mdm
