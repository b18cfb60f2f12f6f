#pragma once
/// \file
/// The grading curve: percent passing over size.

#include "number/power_product.hpp"
#include "soil/available.hpp"

#include <mdm/gradation/gradation.hpp>

#include <cassert>

namespace mdm {

/// The curve through the points (x_i, P_i) of a gradation, x_i the openings in mm and P_i the share of the
/// mass that passes them, linear in log size between them; 0 below x_1 and 1 above x_n. Below a pan at size 0
/// that holds mass it is not known. Density and shape factors do not enter: masses are masses.
class GradingCurve {
public:
  explicit GradingCurve(const Gradation &g);

  /// x_1 < ... < x_n, in mm.
  /// \throws InputError if the gradation's root is above 1: such openings are irrational
  const std::vector<Rational> &sizes() const;
  RootSize opening(std::size_t i) const { return {powers_[i], root_}; }
  /// x_i^exponent. \pre x_i > 0
  PowerProduct power_of(std::size_t i, const Rational &exponent = 1) const {
    assert(powers_[i] > 0);
    return PowerProduct(powers_[i], exponent / root_);
  }
  bool has_pan() const { return powers_.front() == 0; }
  /// 0 = P_1 <= ... <= P_n = 1, exactly.
  const std::vector<Rational> &shares() const { return shares_; }
  /// The finest and the coarsest class with mass; class j is (x_{j+1}, x_{j+2}], counted from 0.
  std::size_t finest() const;
  std::size_t coarsest() const;
  /// Share of the mass in class j.
  Rational mass(std::size_t j) const { return shares_[j + 1] - shares_[j]; }

  /// The share that passes `size` >= 0 (mm), exact at the sieves.
  Available<Real> passing(const Rational &size) const;
  /// True if `size` lies between two sieves with mass between them: passing() is then an interpolation.
  bool interpolates(const Rational &size) const;

  /// D_p in mm: the least size that the share 0 < p <= 1 passes,
  /// x_i (x_{i+1}/x_i)^((p - P_i)/(P_{i+1} - P_i)). Where it falls into a pan at size 0 it is not available,
  /// or, with `extrapolate`, lies on the line through (x_2, P_2) and (x_3, P_3).
  Available<PowerProduct> diameter(const Rational &p, bool extrapolate = false) const;
  /// True if D_p falls into a pan at size 0.
  bool in_pan(const Rational &p) const;

  /// The curve of what passes `size`, which must be a sieve or not be between mass.
  Available<GradingCurve> part_passing(const Rational &size) const;

private:
  GradingCurve() = default;
  Available<PowerProduct> extrapolated(const Rational &p) const;

  std::size_t first_not_below(const Rational &size) const;
  bool is_opening(std::size_t i, const Rational &size) const { return powers_[i] == power(size, root_); }

  std::vector<Rational> powers_; ///< of the openings, to the power of the root
  unsigned root_ = 1;
  std::vector<Rational> shares_;
};

} // namespace mdm
