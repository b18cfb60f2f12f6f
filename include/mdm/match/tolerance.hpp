#pragma once
/// \file
/// How far the shares of a sample may be from those of a gradation.

#include <mdm/gradation/gradation.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// lo <= share <= hi, both closed, 0 <= lo, hi <= 1; lo > hi cannot be met.
struct ShareBounds {
  Rational lo = 0;
  Rational hi = 1;
};

/// What the shares t_j / M of a sample with mass t_j in class j and M = t_1 + ... + t_k must satisfy. Of each
/// kind there is none (empty) or one entry a class.
struct Tolerance {
  std::vector<ShareBounds> retained; ///< of t_j / M
  std::vector<ShareBounds> passing;  ///< of (t_1 + ... + t_j) / M
  std::optional<Rational> total;     ///< most that sum |t_j / M - g_j| may be
};

/// g_j = m_j / sum m.
std::vector<Rational> shares(const Gradation &g);

} // namespace mdm
