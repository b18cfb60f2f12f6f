#pragma once
/// \file
/// Bounds on the shares of consecutive classes.

#include "match/tolerant_problem.hpp"

#include <optional>

namespace mdm {

/// A condition on shares, one of a sum of them.
struct ShareCondition {
  TolerantCondition condition; ///< above_lower: the mass of class j is at least 0
  std::size_t j;               ///< class, 0 where the condition has none
};

/// The bounds on the shares of consecutive classes, P_j - P_{i-1}, that follow from all bounds of a tolerance
/// together (proofs/README.md, Theorem 17): longest paths over the sieves, on which an edge from a to b of
/// weight w says P_b - P_a >= w M. All edges but those between neighbours begin or end at one of two hubs:
/// the finest sieve, for what passes, and the one of a total. Shares are integers in units of 1 / unit().
/// Cost: a few passes over the classes.
class ShareClosure {
public:
  explicit ShareClosure(const TolerantProblem &problem);

  /// True if no shares meet all bounds: a cycle of positive weight. Then there are no bounds.
  bool contradicts() const { return !cycle_.empty(); }
  const Integer &unit() const { return unit_; }
  /// The least and the greatest share of classes i to j together.
  Integer lo(std::size_t i, std::size_t j) const { return length(best_path(i, j + 1), i, j + 1); }
  Integer hi(std::size_t i, std::size_t j) const { return -length(best_path(j + 1, i), j + 1, i); }

  /// Conditions whose sum is t_i + ... + t_j - lo M >= 0, or hi M - t_i - ... - t_j >= 0.
  std::vector<ShareCondition> conditions_of_lo(std::size_t i, std::size_t j) const;
  std::vector<ShareCondition> conditions_of_hi(std::size_t i, std::size_t j) const;
  /// Conditions whose sum is 0 >= w M, and w > 0.
  /// \pre contradicts()
  std::vector<ShareCondition> contradiction() const { return conditions(cycle_); }
  Rational weight_of_contradiction() const;

private:
  /// Without a condition it is part of a total, or says that all mass passes the coarsest sieve.
  struct Edge {
    std::size_t from, to;
    Integer weight;
    std::optional<TolerantCondition> condition;
  };
  using Path = std::vector<std::size_t>; ///< numbers of edges
  /// Longest paths from a hub, or to it: the length, and the edge before or behind the node.
  struct Paths {
    std::vector<std::optional<Integer>> length;
    std::vector<std::optional<std::size_t>> edge;
  };
  /// From a node to another: along neighbours, or over a hub.
  enum class Way { neighbours, finest, total };

  std::size_t hub(Way way) const { return way == Way::finest ? 0 : k_ + 1; }
  void add_edges(const TolerantProblem &problem);
  void add_neighbours(const Tolerance &tolerance);
  void find_paths(Paths &paths, std::size_t hub, bool to_hub);
  bool relax(Paths &paths, const Edge &edge, std::size_t number, bool to_hub) const;
  bool find_cycle(const Paths &paths, bool to_hub);
  std::optional<Integer> along_neighbours(std::size_t a, std::size_t b) const;
  Way best_path(std::size_t a, std::size_t b) const;
  Integer length(Way way, std::size_t a, std::size_t b) const;
  Path path(std::size_t a, std::size_t b) const;
  std::vector<ShareCondition> conditions(const Path &path) const;

  std::size_t k_;
  Integer unit_;
  std::vector<Edge> edges_;
  std::vector<std::optional<std::size_t>> up_, down_; ///< edges from sieve j to j + 1 and back
  std::vector<Integer> sum_up_, sum_down_;            ///< their lengths from sieve 0 on
  std::vector<std::size_t> missing_down_;             ///< those that are not there, from sieve 0 on
  bool has_total_;
  Paths from_[2], to_[2]; ///< of the hubs
  Path cycle_;
};

} // namespace mdm
