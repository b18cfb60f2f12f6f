#pragma once
/// \file
/// Number density f, partition function F, volume fraction V and grading curve h of one set of particles.

#include <mdm/number/real.hpp>

#include <vector>

namespace mdm {

/// Sizes between b_0 < b_1 < ... < b_n, b_0 > 0, within each class uniform by volume (Eq. 2-4), for particles
/// of volume proportional to d^D, D = 2 or 3: a set whose grading curve is linear between the bounds. By Eq.
/// 5 each of f, F, V and h gives the others: h' = V, F' = f and V(d) = d^D f(d) / integral of x^D f(x). Exact
/// where bounds and shares are fractions.
class SizeDistribution {
public:
  /// From h(b_{i+1}) - h(b_i), the shares by volume of the classes; they sum to 1.
  static SizeDistribution by_volume(std::vector<Real> bounds, std::vector<Real> shares, unsigned dimension);
  /// From F(b_{i+1}) - F(b_i), the shares by number.
  static SizeDistribution by_number(std::vector<Real> bounds, std::vector<Real> shares, unsigned dimension);

  const std::vector<Real> &volume_shares() const { return volumes_; }
  const std::vector<Real> &number_shares() const { return numbers_; }

  /// h(d), F(d), V(d) = h'(d), f(d) = F'(d), for b_0 <= d <= b_n; at a bound the densities are those above
  /// it.
  Real grading(const Real &d) const;
  Real partition(const Real &d) const;
  Real volume_density(const Real &d) const;
  Real number_density(const Real &d) const;

private:
  SizeDistribution(std::vector<Real> bounds, unsigned dimension)
      : bounds_(std::move(bounds)), dimension_(dimension) {}
  /// The class with b_i <= d < b_{i+1}; the last at b_n.
  std::size_t class_of(const Real &d) const;
  /// The number of particles in class i that have volume 1, up to a constant.
  Real number_in_volume(std::size_t i) const;

  std::vector<Real> bounds_, volumes_, numbers_;
  unsigned dimension_;
};

} // namespace mdm
