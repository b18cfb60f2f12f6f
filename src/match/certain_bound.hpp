#pragma once
/// \file
/// Exact bounds on the number of particles from multipliers that doubles have found.

#include "match/count_bounds.hpp"
#include "match/tolerant_problem.hpp"

namespace mdm {

/// A condition and about how many times it is to be taken.
struct Steering {
  TolerantCondition condition;
  std::size_t i, j;
  double multiplier; ///< > 0
};

/// What is certain within some bounds on counts.
struct CertainBound {
  std::optional<Integer> particles; ///< no match has fewer; nothing: there is no match
  TreeNode leaf;                    ///< refutes fewer particles, or any number
};

/// Makes exact bounds of multipliers that are nearly right. Conditions on shares, and on sums of counts, are
/// taken as often as the doubles say; what they leave of masses is cancelled by above_lower or up_to_upper of
/// each class, of counts by its least_count or most_count, of excesses by excess_sign; the conditions that
/// are left then say exactly how many particles there are at least (proofs/README.md, Theorem 14).
class BoundMaker {
public:
  explicit BoundMaker(const TolerantProblem &problem);

  /// `fewer` among the conditions is the number of particles, which is to be bounded.
  CertainBound bound(const CountBounds &bounds, const std::vector<Steering> &steering) const;

private:
  struct Sum;
  Sum steered(const CountBounds &bounds, const std::vector<Steering> &steering) const;
  void add(Sum &sum, const Steering &of, const Integer &m) const;
  void add_counts(Sum &sum, const CountBounds &bounds, const Steering &of, const Integer &m) const;
  void correct(Sum &sum, const CountBounds &bounds) const;

  const TolerantProblem &problem_;
  std::size_t k_;
  Integer unit_; ///< of shares, weights and the demanded weight
  std::vector<Integer> target_, per_mass_;
  std::vector<std::pair<Integer, Integer>> retained_, passing_; ///< lo and hi
  Integer half_total_, weight_;
};

} // namespace mdm
