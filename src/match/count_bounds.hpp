#pragma once
/// \file
/// Counts that every match within a tolerance reaches.

#include "match/tolerant_match.hpp"

namespace mdm {

/// A sweep as for the least match, with the bounds on each class's share in the place of its share (Theorem
/// 17). It ends at the least match itself where the tolerance is 0. Cost: as the least match's.
class CountBounds {
public:
  CountBounds(const TolerantProblem &problem, const Limits &limits, const Watch &watch);

  /// Every match has at least so many particles in each class, whether the sweep came to its end or not.
  const std::vector<Integer> &q() const { return q_; }
  /// The tree that refutes total(q()) - 1 particles; empty if it is too long for a certificate, or was not to
  /// be kept.
  Tree tree() const;

private:
  /// The tightest bound on a share, and what it comes from.
  enum class Origin { nothing, retained, passing, total };
  struct ShareBound {
    Rational share;
    Origin origin = Origin::nothing;
  };
  /// Why a class has n particles or more: those of the class `of`, the weight, or that there is mass.
  enum class Reason { mass, weight, particles };
  struct Step {
    std::size_t j;
    Integer n;
    Reason reason;
    std::size_t of = 0;
  };
  class Leaf;

  ShareBound lower(std::size_t j) const;
  ShareBound upper(std::size_t j) const;
  bool contradict() const;
  void start();
  void sweep(const Limits &limits, const Watch &watch);
  void raise_all();
  Integer count(std::size_t j) const;
  Integer settled_count(std::size_t j) const;
  void raise(std::size_t j, const Integer &n, Reason reason);
  bool sets_level(std::size_t j);
  TreeNode refutation(const Step &step) const;

  const TolerantProblem &problem_;
  std::vector<ShareBound> lower_, upper_;
  std::vector<Integer> q_;
  Rational heaviest_ = 0;  ///< greatest weight of a mass
  Rational per_mass_ = 0;  ///< sum t_j / c_j is at most this times M
  Rational level_ = 0;     ///< the mass M of every match is above this
  std::size_t source_ = 0; ///< the class that says so
  std::vector<Step> steps_;
  bool keeps_steps_;
  bool too_long_ = false; ///< steps were left out
};

} // namespace mdm
