#pragma once
/// \file
/// Sums of doubles with their errors.

#include "packing/sphere_sample.hpp"

#include <mdm/number/interval.hpp>

#include <cmath>
#include <cstdint>

namespace mdm::packing {

/// Encloses a sum of real numbers, of each of which a double and its greatest error are known.
class EnclosedSum {
public:
  void add(double value, double error) {
    ++terms_;
    sum_ += value;
    magnitude_ += std::abs(value);
    errors_ += error;
  }

  /// Adding n doubles one after the other errs by less than n u / (1 - n u) of the sum of their absolute
  /// values, u = 2^-53. What is computed of that sum, and of the errors, is less than n u smaller itself:
  /// twice both, for less than 2^50 terms, is no less than the error.
  Interval interval() const {
    const Rational unit = ratio(1, power(Integer(2), 53));
    const Rational error = 2 * (Rational(terms_) * unit * Rational(magnitude_) + Rational(errors_));
    return {Rational(sum_) - error, Rational(sum_) + error};
  }

private:
  std::uint64_t terms_ = 0;
  double sum_ = 0, magnitude_ = 0, errors_ = 0;
};

} // namespace mdm::packing
