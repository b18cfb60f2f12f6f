#pragma once
/// \file
/// The evidence that no smaller set matches: a chain of an exact match, a tree of one within a tolerance.

#include <mdm/number/rational.hpp>

#include <cstdint>
#include <optional>
#include <variant>
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

/// The conditions that a match within a tolerance meets (proofs/README.md, Theorem 12), on the particles q_j,
/// the masses t_j and, for a total tolerance, the excesses p_j; M = t_1 + ... +
/// t_k.
enum class TolerantCondition {
  above_lower,  ///< t_j - f_j q_j >= 0, strict where q_j >= 1
  up_to_upper,  ///< F_j q_j - t_j >= 0
  least_count,  ///< q_j >= what min_per_class or a branch demands
  most_count,   ///< q_j <= what a branch allows
  retained_lo,  ///< t_j - lo_j M >= 0
  retained_hi,  ///< hi_j M - t_j >= 0
  passing_lo,   ///< t_1 + ... + t_j - lo_j M >= 0
  passing_hi,   ///< hi_j M - t_1 - ... - t_j >= 0
  excess,       ///< p_j - t_j + g_j M >= 0
  excess_sign,  ///< p_j >= 0
  excess_total, ///< (total / 2) M - p_1 - ... - p_k >= 0
  some_mass,    ///< M > 0
  weight,       ///< sum t_j / c_j >= what a volume demands
  at_least,     ///< q_1 + ... + q_k >= what is asked for, at least 1
  fewer,        ///< q_1 + ... + q_k <= N - 1, what is to be refuted
  least_sum,    ///< q_i + ... + q_j >= what a branch demands, else 0
  most_sum,     ///< q_i + ... + q_j <= what a branch allows
  above_lowers, ///< the sum of t_b - f_b q_b over the classes i to j >= 0, strict where a branch demands q_i
                ///< + ... + q_j >= 1
  whole_lo,     ///< of windows: t_1 + ... + t_k >= M
  whole_hi      ///< of windows: t_1 + ... + t_k <= M
};

/// A multiple of a condition in a refutation.
struct Multiple {
  TolerantCondition condition;
  std::size_t j = 0;  ///< class of the gradation, from 0; 0 where the condition has none
  Integer multiplier; ///< > 0
  std::size_t i = 0;  ///< of a sum, the first class
};

/// A node of a search tree: a split of the count q = q_i + ... + q_j, first into q < v and then q >= v; a
/// split of the mass, first into M <= mass and then M > mass; a leaf, where the multiples of conditions add
/// up to a contradiction; or a leaf of the window of M that these splits leave, where the multiples are of
/// conditions on the shares t_j / M (proofs/README.md, Theorem 20).
struct TreeNode {
  std::size_t i = 0, j = 0; ///< i = j: a single class
  Integer v;
  std::vector<Multiple> leaf;
  std::optional<Rational> mass = std::nullopt; ///< in the problem's units
  bool is_window = false;

  bool is_split() const { return leaf.empty() && !is_window; }
};

/// Refutes fewer particles than the match has, or any number where there is none. Nodes are in preorder: a
/// split is followed by its first subtree, then its second.
using Tree = std::vector<TreeNode>;

/// Nodes and multiples of a tree that a certificate can have. A longer one is not kept.
constexpr std::size_t longest_tree = std::size_t{1} << 22;

/// The reason why there is no match with fewer particles: the chain of an exact match, the tree of one within
/// a tolerance.
using Evidence = std::variant<Chain, Tree>;

} // namespace mdm
