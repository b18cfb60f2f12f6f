#pragma once
/// \file
/// Number density f, partition function F, volume fraction V and grading curve h of one set of particles.

#include "number/real.hpp"

#include <map>
#include <memory>
#include <vector>

namespace mdm {

/// The sums of the first 0, 1, ..., n terms, worked out together once for each precision. Not for several
/// threads at a time.
class PartialSums {
public:
  explicit PartialSums(std::vector<Real> terms);

  Real of_first(std::size_t n) const;
  Real of_all() const { return of_first(terms_.size()); }

private:
  std::vector<Real> terms_;
  std::vector<Rational> exact_; ///< the sums, if all terms are fractions
  std::shared_ptr<std::map<unsigned, std::vector<Ball>>> known_;
};

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

  /// The share of class i.
  Real volume_share(std::size_t i) const { return volumes_[i] / volumes_below_.of_all(); }
  Real number_share(std::size_t i) const { return numbers_[i] / numbers_below_.of_all(); }

  /// h(d), F(d), V(d) = h'(d), f(d) = F'(d), for b_0 <= d <= b_n; at a bound the densities are those above
  /// it.
  Real grading(const Real &d) const;
  Real partition(const Real &d) const;
  Real volume_density(const Real &d) const;
  Real number_density(const Real &d) const;

private:
  SizeDistribution(std::vector<Real> bounds, std::vector<Real> volumes, std::vector<Real> numbers,
                   unsigned dimension);
  /// True at b_n, where h and F are 1: enclosures do not tell that.
  bool is_end(const Real &d) const;
  /// The class with b_i <= d < b_{i+1}; the last at b_n.
  std::size_t class_of(const Real &d) const;

  std::vector<Real> bounds_, volumes_, numbers_; ///< volumes and numbers up to constants
  PartialSums volumes_below_, numbers_below_;
  unsigned dimension_;
};

} // namespace mdm
