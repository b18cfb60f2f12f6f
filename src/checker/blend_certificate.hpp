#pragma once

#include "gradation.hpp"

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace mdm::checker {

/// m > 0 times a condition on what passes a sieve, counted from 1: `l` at least its lower limit, `u` at most
/// its upper one; `a` and `b` the deviation from the target, below it and above.
struct SieveMultiple {
  mpq_class m;
  char condition;
  std::uint64_t sieve;
};

/// A node of a tree: a split of a stockpile's steps, counted from 1, into at most `at` and more; or a leaf,
/// which says that no blend of its box has a lower value, or that there is none.
struct BlendNode {
  enum Kind { split, leaf, none };
  Kind kind;
  std::uint64_t stockpile = 0, at = 0;
  std::vector<SieveMultiple> multiples;
};

/// Limits of a stockpile's share.
struct ShareLimits {
  std::uint64_t stockpile;
  mpq_class least, most;
};

/// Limits of the fineness modulus of ASTM C125, or of EN 12620.
struct ModulusLimits {
  enum Standard { astm, en };
  Standard standard;
  mpq_class least, most;
};

/// The sieves of a fineness modulus, in mm.
const Rationals &modulus_sieves(ModulusLimits::Standard standard);

/// Limits of the coarseness factor.
struct CoarsenessLimits {
  mpq_class least, most;
};

/// The numbers of each line of a certificate of a blend (section 11).
struct BlendCertificate {
  enum Aim { no_aim, cost, deviation, max_deviation, squares };
  std::uint64_t steps = 0;
  std::vector<ShareLimits> shares;
  std::optional<std::uint64_t> at_most;
  std::vector<ModulusLimits> moduli;
  std::optional<CoarsenessLimits> coarseness;
  Aim aim = no_aim;
  Rationals of_aim;                                ///< costs, or targets
  std::optional<std::vector<std::uint64_t>> blend; ///< steps of each stockpile; or there is none
  std::vector<BlendNode> tree;                     ///< in preorder; empty where a blend has no aim
  std::uint64_t terms = 0, longest_leaf = 0, longest_bits = 0; ///< for the limits

  bool has_targets() const { return aim == deviation || aim == max_deviation || aim == squares; }
};

/// Reads a certificate (section 11).
BlendCertificate read_blend_certificate(std::string_view text);

} // namespace mdm::checker
