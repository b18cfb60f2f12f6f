#include "soil/mean_sizes.hpp"

namespace mdm {
namespace {

/// x_i, known exactly where it is a fraction.
Real size_at(const GradingCurve &curve, std::size_t i) {
  const std::optional<Rational> fraction = curve.opening(i).fraction();
  return fraction ? Real(*fraction) : curve.power_of(i).real();
}

/// The sum of w_j term(size) over the classes from `first` to `last` with mass, each at its sieve j + side.
/// By halves: the common denominator of many fractions is long.
template <class Term>
Real sum_of_part(const GradingCurve &curve, std::size_t first, std::size_t last, std::size_t side,
                 Term term) {
  if (first == last)
    return curve.mass(first) > 0 ? Real(curve.mass(first)) * term(size_at(curve, first + side)) : Real(0);
  const std::size_t middle = first + (last - first) / 2;
  return sum_of_part(curve, first, middle, side, term) + sum_of_part(curve, middle + 1, last, side, term);
}

template <class Term>
Real sum_over_classes(const GradingCurve &curve, std::size_t side, Term term) {
  return sum_of_part(curve, curve.finest(), curve.coarsest(), side, term);
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
