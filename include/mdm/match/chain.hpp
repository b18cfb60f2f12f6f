#pragma once
/// \file
/// The evidence that no smaller set matches exactly.

#include <mdm/number/rational.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace mdm {

/// The steps that prove minimality, or a bound (proofs/README.md, Theorem 5), each a class of the gradation,
/// from 0. From L = 0, or `above`, each step j replaces the lower bound L on the scale by count_j(L)^p f_j /
/// m_j^p, where count_j(L) is the least count that class j needs above L. All empty where no more is shown
/// than the particles that the question asks for: that needs no proof.
struct Chain {
  /// No match with as many particles as are asked for has a scale, to the scale power, up to this (Theorem
  /// 7). Nothing: that holds for every scale from 0 on.
  std::optional<Rational> above;
  std::vector<std::uint32_t> steps;
};

} // namespace mdm
