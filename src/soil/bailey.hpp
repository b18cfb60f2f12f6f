#pragma once
/// \file
/// The ratios of the Bailey method (Vavrik and others, Transportation Research Circular E-C044, 2002).

#include <mdm/number/rational.hpp>

#include <array>
#include <optional>
#include <vector>

namespace mdm {

/// Sieves of a nominal maximum particle size, in mm: half of it, and the primary, secondary and tertiary
/// control sieves, the standard ones nearest to 0.22 times the size before.
struct BaileySieves {
  Rational nominal, half, primary, secondary, tertiary;
};

/// Those of 37.5, 25, 19, 12.5, 9.5 and 4.75 mm.
const std::array<BaileySieves, 6> &bailey_sieves();

/// Ratios of what passes; nothing where one is divided by 0.
struct BaileyRatios {
  std::optional<Rational> coarse;      ///< CA: (half - primary) / (100 - half)
  std::optional<Rational> fine_coarse; ///< FAc: secondary / primary
  std::optional<Rational> fine_fine;   ///< FAf: tertiary / secondary
};

/// \param passing  percents at half, primary, secondary and tertiary sieve
BaileyRatios bailey_ratios(const std::array<Rational, 4> &passing);

} // namespace mdm
