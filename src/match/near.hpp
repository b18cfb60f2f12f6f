#pragma once
/// \file
/// Doubles near exact numbers, for what only steers a search.

#include <mdm/number/rational.hpp>

namespace mdm {

/// Within 2^-52 of n, relatively; infinite beyond doubles.
inline double near(const Integer &n) {
  return n.convert_to<double>();
}
inline double near(const Rational &r) {
  return mpq_get_d(r.backend().data());
}

} // namespace mdm
