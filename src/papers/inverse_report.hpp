#pragma once
/// \file
/// The shapes with a C_u and a C_c as text, JSON, CSV and map.

#include "plot/figure.hpp"
#include "sets/inverse_model.hpp"

namespace mdm {

/// What was found at one span.
struct InverseRow {
  Rational span;
  InverseShapes shapes;
};

/// A line a span and box, with what is proved of it, for people.
std::string inverse_text(const InverseTask &task, const std::vector<InverseRow> &rows);

/// One line of JSON, schema `mdm-inverse-1`, without a newline at its end.
std::string inverse_json(const InverseTask &task, const std::vector<InverseRow> &rows);

/// span,a_lo,a_hi,b_lo,b_hi,shapes: a row a box, `one or more` or `not certain`; `none` without a box.
std::string inverse_csv(const std::vector<InverseRow> &rows);

/// The boxes over a and b, coloured by their span.
Figure inverse_map(const InverseTask &task, const std::vector<InverseRow> &rows);

} // namespace mdm
