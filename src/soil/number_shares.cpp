// From one kind of shares to the other. What comes in are shares w_j of the classes; what goes out is, for
// each class, the range of w_j t_j / sum of w_i t_i, where t is x^3 from number to mass and x^-3 from mass to
// number, and x any size of its class. The fraction grows with t_j and falls with every other t_i, so its
// ends are at the sieves. At a pan t may be as small, or as large, as one likes: then a share may be none, or
// all.

#include "soil/number_shares.hpp"

#include <algorithm>
#include <optional>

namespace mdm {
namespace {

/// w t at both ends of a class; nothing: beyond every bound.
struct WeightRange {
  Real least;
  std::optional<Real> greatest;
};

/// x_i^exponent, exactly where x_i is a fraction. \pre x_i > 0
Real cube(const GradingCurve &curve, std::size_t i, int exponent) {
  const std::optional<Rational> x = curve.opening(i).fraction();
  if (!x)
    return curve.power_of(i, exponent).real();
  const Rational third = *x * *x * *x;
  return Real(exponent > 0 ? third : Rational(1 / third));
}

WeightRange weights(const GradingCurve &curve, std::size_t j, ShareOf given) {
  const Real share(curve.mass(j));
  const bool is_pan = curve.has_pan() && j == 0;
  if (given == ShareOf::number)
    return {is_pan ? Real(0) : share * cube(curve, j, 3), share * cube(curve, j + 1, 3)};
  return {share * cube(curve, j + 1, -3), is_pan ? std::nullopt : std::optional(share * cube(curve, j, -3))};
}

/// own / (own + others). \pre others >= 0, and not both are 0
Real part(const Real &own, const Real &others) {
  return own.fraction() == Rational(0) ? Real(0) : own / (own + others);
}

} // namespace

std::vector<RealRange> other_shares(const GradingCurve &curve, ShareOf given) {
  const std::size_t first = curve.finest(), last = curve.coarsest();
  std::vector<RealRange> shares(curve.shares().size() - 1, RealRange{Real(0), Real(0)});
  if (first == last) {
    shares[first] = {Real(1), Real(1)};
    return shares;
  }
  std::vector<std::optional<WeightRange>> all(shares.size());
  Real least(0), greatest(0); // sums, of what is bounded
  for (std::size_t j = first; j <= last; ++j) {
    if (curve.mass(j) == 0)
      continue;
    all[j] = weights(curve, j, given);
    least = least + all[j]->least;
    if (all[j]->greatest)
      greatest = greatest + *all[j]->greatest;
  }
  const bool is_unbounded = !all[first]->greatest;
  for (std::size_t j = first; j <= last; ++j) {
    if (!all[j])
      continue;
    const std::optional<Real> &most = all[j]->greatest;
    shares[j].lo = most && is_unbounded ? Real(0) : part(all[j]->least, most ? greatest - *most : greatest);
    shares[j].hi = most ? part(*most, least - all[j]->least) : Real(1);
  }
  return shares;
}

} // namespace mdm
