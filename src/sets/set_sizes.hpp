#pragma once
/// \file
/// The sizes of a representative set.

#include "number/philox.hpp"
#include "sets/quick_sizes.hpp"
#include "sets/set_quality.hpp"
#include "sets/uniform_by_volume.hpp"

namespace mdm {

/// Sizes drawn in one class by inverse sampling of the distribution uniform by volume. Bounds that are no
/// fractions are taken as narrow intervals around them: F^-1 grows with both bounds.
class ClassSizes {
public:
  /// `digits` are significant digits of the sizes.
  ClassSizes(const SizeClass &c, unsigned dimension, unsigned digits);

  /// Decimals around F^-1(y), 0 < y < 1, one unit apart, or the size itself if it is such a decimal. They lie
  /// inside the class, open below and closed above: digits are raised where they do not tell the size from
  /// its bounds. Cost: some 50 microseconds.
  Enclosure at(const Rational &y) const;
  /// The same for every y in [Y, Y + 1] / 2^64, where that is decided quickly.
  std::optional<ShortSize> quick(std::uint64_t y) const { return quick_.at(y); }
  /// True in dimension 2 between bounds that are fractions: so are sizes then.
  bool has_fractions() const { return exact_ && below_.power() == 1; }
  /// F^-1(y) exactly, if has_fractions().
  std::optional<Rational> exact(const Rational &y) const;

private:
  Rational greatest_lower_, least_upper_; // of the class
  UniformByVolume below_, above_;         // the same where the bounds are fractions
  bool exact_;
  unsigned digits_;
  QuickSizes quick_;
};

/// The number y of particle i of q in class j, all counted from 0, by which its size is drawn.
class Draws {
public:
  /// (2 r + 1) / 2^65, with 64 random bits r of Philox: stream j, number i, key `seed`.
  static Draws random(std::uint64_t seed) { return Draws(Philox(seed)); }
  /// (2 i + 1) / (2 q): no randomness.
  static Draws quantiles() { return Draws(std::nullopt); }

  Rational operator()(std::uint64_t j, std::uint64_t i, const Integer &q) const;
  /// floor(2^64 y). \pre i < q
  std::uint64_t bits(std::uint64_t j, std::uint64_t i, std::uint64_t q) const;

private:
  explicit Draws(std::optional<Philox> philox) : philox_(philox) {}

  std::optional<Philox> philox_;
};

/// The particles of a set by Eq. 6-10: numbers[j] < 2^64 of them drawn in class j.
ParticlesOf drawn_particles(const std::vector<SizeClass> &classes, const std::vector<Integer> &numbers,
                            unsigned dimension, unsigned digits, const Draws &draws);

} // namespace mdm
