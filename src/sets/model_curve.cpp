#include "sets/model_curve.hpp"

namespace mdm {

Real uniformity(const ModelCurve &curve) {
  return curve.diameter(ratio(6, 10)) / curve.diameter(ratio(1, 10));
}

Real curvature(const ModelCurve &curve) {
  const Real d30 = curve.diameter(ratio(3, 10));
  return d30 * d30 / (curve.diameter(ratio(6, 10)) * curve.diameter(ratio(1, 10)));
}

} // namespace mdm
