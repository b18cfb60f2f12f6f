#include "soil/share_limits.hpp"

namespace mdm {

bool is_at_least(const Real &a, const Rational &factor, const Real &b) {
  const Order order = compare(a, Real(factor) * b);
  if (order == Order::undecided)
    throw NotAvailable{"1,200 digits do not tell a share from a limit", true};
  return order != Order::less;
}

std::vector<Real> shares_passing(const GradingCurve &curve, const std::vector<Rational> &sizes) {
  std::vector<Real> shares;
  for (const Rational &size : sizes) {
    const Available<Real> share = curve.passing(size);
    if (!share)
      throw share.why();
    shares.push_back(*share);
  }
  return shares;
}

} // namespace mdm
