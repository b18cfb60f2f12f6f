#pragma once
/// \file
/// The sample S = (X_S, Q_S).

#include <mdm/number/rational.hpp>

#include <vector>

namespace mdm {

/// S of Arnold, Eq. 1-4: sizes 0 < x_1 < ... < x_n and their quantities q_i >= 1. A sample may be empty.
class Sample {
public:
  Sample() = default;
  /// \throws InputError naming the size where an invariant of the class does not hold
  Sample(std::vector<Rational> sizes, std::vector<Integer> quantities);

  const std::vector<Rational> &sizes() const { return sizes_; }
  const std::vector<Integer> &quantities() const { return quantities_; }
  /// N, the sum of the quantities.
  Integer particles() const;

private:
  std::vector<Rational> sizes_;
  std::vector<Integer> quantities_;
};

} // namespace mdm
