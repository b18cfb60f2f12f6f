#pragma once
/// \file
/// The sizes of a representative set.

#include <mdm/grading/size_classes.hpp>
#include <mdm/grading/uniform_by_volume.hpp>
#include <mdm/number/philox.hpp>

namespace mdm {

/// Sizes drawn in one class by inverse sampling of the distribution uniform by volume. Bounds that are no
/// fractions are taken as narrow intervals around them: F^-1 grows with both bounds.
class ClassSizes {
public:
  /// `digits` are significant digits of the sizes.
  ClassSizes(const SizeClass &c, unsigned dimension, unsigned digits);

  /// Decimals around F^-1(y), 0 < y < 1. They lie inside the class: digits are raised where y is near 0 or 1.
  Enclosure at(const Rational &y) const;
  /// F^-1(y) exactly: in dimension 2, between bounds that are fractions.
  std::optional<Rational> exact(const Rational &y) const;

private:
  Rational greatest_lower_, least_upper_; // of the class
  UniformByVolume below_, above_;         // the same where the bounds are fractions
  bool exact_;
  unsigned digits_;
};

/// The number y of particle i of q in class j, all counted from 0, by which its size is drawn.
class Draws {
public:
  /// (2 r + 1) / 2^65, with 64 random bits r of Philox: stream j, number i, key `seed`.
  static Draws random(std::uint64_t seed) { return Draws(Philox(seed)); }
  /// (2 i + 1) / (2 q): no randomness.
  static Draws quantiles() { return Draws(std::nullopt); }

  Rational operator()(std::uint64_t j, std::uint64_t i, const Integer &q) const;

private:
  explicit Draws(std::optional<Philox> philox) : philox_(philox) {}

  std::optional<Philox> philox_;
};

} // namespace mdm
