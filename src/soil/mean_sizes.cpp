#include "soil/mean_sizes.hpp"

namespace mdm {
namespace {

/// x_i, known exactly where it is a fraction.
Real size_at(const GradingCurve &curve, std::size_t i) {
  const std::optional<Rational> fraction = curve.opening(i).fraction();
  return fraction ? Real(*fraction) : curve.power_of(i).real();
}

/// The sum of w_j term(size) over the classes with mass, each at its sieve j + side.
template <class Term>
Real sum_over_classes(const GradingCurve &curve, std::size_t side, Term term) {
  Real sum(0);
  for (std::size_t j = curve.finest(); j <= curve.coarsest(); ++j)
    if (curve.mass(j) > 0)
      sum = sum + Real(curve.mass(j)) * term(size_at(curve, j + side));
  return sum;
}

bool holds_mass_in_pan(const GradingCurve &curve) {
  return curve.has_pan() && curve.finest() == 0;
}

const NotAvailable sizes_in_pan = {"the sizes in the pan are not known"};

} // namespace

Available<RealRange> surface_mean(const GradingCurve &curve) {
  if (holds_mass_in_pan(curve))
    return sizes_in_pan;
  const auto mean = [&curve](std::size_t side) {
    return Real(1) / sum_over_classes(curve, side, [](const Real &x) { return Real(1) / x; });
  };
  return RealRange{mean(0), mean(1)};
}

Available<RealRange> volume_mean(const GradingCurve &curve) {
  if (holds_mass_in_pan(curve))
    return sizes_in_pan;
  const auto mean = [&curve](std::size_t side) {
    return sum_over_classes(curve, side, [](const Real &x) { return x; });
  };
  return RealRange{mean(0), mean(1)};
}

} // namespace mdm
