#pragma once
/// \file
/// A problem with its denominators cleared, for the algorithms' inner loops.

#include <mdm/match/problem.hpp>
#include <mdm/number/int128.hpp>

#include <vector>

namespace mdm {

/// The classes of a Problem in integers: f, F and mass are multiplied by common denominators, which changes every scale
/// by the same factor and no comparison of scales. Beside them stand doubles for decisions that are not close.
///
/// Error bounds of the doubles (u = 2^-53; a conversion from Int is off by at most 2u, an operation by u): `lower` is
/// f / mass within 5u, `per_upper` is mass / F within 5u, relative, and both are 0 (lower of f = 0) or in
/// [2^-200, 2^200]. Where that cannot be had, or the law has b > 1, both are NaN: then every comparison with them is
/// false and the exact decision follows.
///
/// Int is Int128 or Integer.
template <class Int>
struct ClearedClass {
  Int f, F, mass, floor;
  double lower = 0;
  double per_upper = 0;
};

template <class Int>
struct ClearedProblem {
  std::vector<ClearedClass<Int>> classes;
  unsigned b = 1;

  /// \throws Int128Overflow if Int is Int128 and a number does not fit
  explicit ClearedProblem(const Problem &problem);
};

extern template struct ClearedProblem<Int128>;
extern template struct ClearedProblem<Integer>;

/// n as a double within 2u, or NaN from 2^500 on.
inline double to_double(Int128 n) { return n.to_double(); }
double to_double(const Integer &n);

} // namespace mdm
