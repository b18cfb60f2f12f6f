#pragma once
/// \file
/// A problem in the number type of the sweep's inner loop.

#include "match/problem.hpp"
#include "number/int128.hpp"

#include <vector>

namespace mdm {

/// A class of a Problem in numbers of type Int. Beside them stand doubles for decisions that are not close.
///
/// Error bounds of the doubles (u = 2^-53; a conversion from Int is off by at most 2u, an operation by u):
/// `lower` is f / mass within 5u, `per_upper` is mass / F within 5u, relative, and both are 0 (lower of f =
/// 0) or in [2^-200, 2^200]. Where that cannot be had, or b > 1, both are NaN: then every
/// comparison with them is false and the exact decision follows. The bounds need rounding to nearest and no
/// -ffast-math (Lemma 11).
///
/// Int is Int128 or Integer.
template <class Int>
struct SweepClass {
  Int f, F, mass;
  Int floor;   ///< r
  Int settled; ///< least count n >= 1 with n^b F >= (n + 1)^b f: from it on the class cannot raise a scale
  double floor_approx; ///< to_double(floor)
  double lower;
  double per_upper;
};

/// A Problem with all its classes in numbers of type Int.
template <class Int>
struct SweepProblem {
  std::vector<SweepClass<Int>> classes;
  unsigned b = 1; ///< the scale power of the problem

  /// \throws Int128Overflow if Int is Int128 and a number does not fit
  explicit SweepProblem(const Problem &problem);
};

extern template struct SweepProblem<Int128>;
extern template struct SweepProblem<Integer>;

/// Least count n >= 1 with n^b F >= (n + 1)^b f; ceil(f / (F - f)) for b = 1 and f > 0 (Theorem 3).
Integer settled_count(const ProblemClass &c, unsigned b);

/// n as a double within 2u, or NaN from 2^500 on.
inline double to_double(Int128 n) {
  return n.to_double();
}
/// An integer of any length as a double, within 2u, or NaN from 2^500 on.
double to_double(const Integer &n);

} // namespace mdm
