#pragma once
/// \file
/// What may be lost in sieving.

#include "gradation/printed_number.hpp"

#include <mdm/gradation/read_gradation.hpp>

namespace mdm {

/// The part of a mass that sieving may lose: --loss, or 1 percent.
class AllowedLoss {
public:
  explicit AllowedLoss(const Reading &reading)
      : percent_(reading.loss.value_or(Rational(1))), is_asked_(reading.loss.has_value()) {}

  const Rational &percent() const { return percent_; }
  /// True where the user says it.
  bool is_asked() const { return is_asked_; }
  /// True where two parts of `whole` differ by no more than is lost, and what rounding explains.
  bool explains(const PrintedNumber &a, const PrintedNumber &b, const Rational &whole) const {
    return abs(Rational(a.value - b.value)) <= percent_ * whole / 100 + a.half + b.half;
  }
  /// True where two masses of the whole differ by no more than that.
  bool explains(const PrintedNumber &a, const PrintedNumber &b) const {
    return explains(a, b, std::max(a.value, b.value));
  }

private:
  Rational percent_;
  bool is_asked_;
};

} // namespace mdm
