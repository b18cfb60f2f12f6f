#pragma once
/// \file
/// The result that every algorithm of Arnold's paper has in common.

#include "match/class_errors.hpp"
#include "match/quantity_ratios.hpp"

#include <cstdint>

namespace mdm {

/// One sample that an algorithm built. Vectors have an entry for each class of the gradation.
struct PublishedTry {
  std::uint64_t multiple = 1; ///< i of the algorithms' step 4: particles of the reference class
  std::uint64_t sizes = 1;    ///< sizes x_nS of the reference class that were tried up to this sample
  std::vector<Integer> q;     ///< quantities; 0 where no particle is called for
  ClassErrors error;          ///< of the sample as it is: a particle counts in the class that it lies in
};

/// A run: its tries, one an iteration, the last of them its result.
struct Published {
  std::vector<Rational> phi; ///< Phi (Eq. 15)
  /// Z (Eq. 16) of the result, every class but the reference at its largest size and at its smallest; nothing
  /// for the size 0. Fixed sizes make both the same.
  std::vector<Rational> least_zeta;
  std::vector<std::optional<Rational>> most_zeta;
  std::vector<Rational> powers; ///< x^a of the sizes x of the result's particles; 0 where there are none
  std::vector<PublishedTry> tries;
  bool reached = false; ///< the algorithm's own end was reached: tolerance, or an integer in every span

  const PublishedTry &result() const { return tries.back(); }
  /// True if the result is an exact match (Cond4, Eq. 12), whatever the algorithm claims.
  bool is_match() const { return result().error.total == 0; }
};

} // namespace mdm
