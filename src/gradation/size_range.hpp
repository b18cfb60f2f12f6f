#pragma once
/// \file
/// A size of which a range is known.

#include <mdm/number/rational.hpp>

namespace mdm {

/// A size x > 0 with lo <= x <= hi; lo < x where is_open.
struct SizeRange {
  Rational lo, hi;
  bool is_open = false; ///< below

  /// True if x is known: it is hi.
  bool is_point() const { return lo == hi; }
};

} // namespace mdm
