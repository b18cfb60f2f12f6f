#pragma once
/// \file
/// The inverse of the beta model: the shapes with given C_u and C_c (proofs/README.md, Theorem 25).

#include <mdm/number/interval.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace mdm {

/// What the curve is to have: C_u and C_c, enclosed where they are irrational, at a span, for a and b in one
/// range.
struct InverseQuestion {
  Interval c_u, c_c;
  Rational span;   ///< 0 < s < 1
  Interval within; ///< of a and of b, inside that of BetaCurve
};

/// A box of shapes.
struct ShapeBox {
  Interval a, b;
  /// A shape with the C_u and C_c is proved to be in it. Else it is only not excluded.
  bool holds_one = false;
};

/// All shapes with the C_u and C_c in the range lie in the boxes, which do not meet. That a box has one shape
/// alone is not claimed.
struct InverseShapes {
  std::vector<ShapeBox> boxes; ///< ascending in a; none: there is no such shape in the range
  bool complete = true;        ///< a limit on the work did not end the search before boxes were narrow
  std::uint64_t examined = 0;  ///< boxes of the search

  /// Everything is decided: each box holds a shape.
  bool is_certain() const;
};

/// Cost: some seconds; a millisecond a box of the search, of which there are some thousands.
/// \pre 1 <= c_u and 0 < c_c
InverseShapes inverse_shapes(const InverseQuestion &question);

/// One question at several spans.
struct InverseTask {
  std::string what; ///< C_u and C_c in words
  Interval c_u, c_c;
  std::vector<Rational> spans; ///< ascending
  Interval within;             ///< of a and of b
  std::vector<std::string> notes;

  InverseQuestion at(const Rational &span) const { return {c_u, c_c, span, within}; }
};

} // namespace mdm
