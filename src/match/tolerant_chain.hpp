#pragma once
/// \file
/// Counts of consecutive classes that every match within a tolerance reaches.

#include "match/share_closure.hpp"
#include "match/watch.hpp"

#include <mdm/match/limits.hpp>

namespace mdm {

/// The intervals of classes whose counts are bounded: i to j, 0 <= i <= j < k. Either all of them, or those
/// that begin at the finest class and single classes.
class ClassIntervals {
public:
  ClassIntervals(std::size_t classes, bool all) : k_(classes), all_(all) {}

  std::size_t size() const { return all_ ? k_ * k_ : 2 * k_; }
  bool has(std::size_t i, std::size_t j) const { return all_ || i == 0 || i == j; }
  /// The intervals that begin at class i end at the classes from i to this one.
  std::size_t last(std::size_t i) const { return all_ || i == 0 ? k_ - 1 : i; }
  /// The place of an interval in a vector of size() elements.
  std::size_t place(std::size_t i, std::size_t j) const { return all_ ? i * k_ + j : (i == 0 ? j : k_ + j); }
  std::size_t classes() const { return k_; }
  bool are_all() const { return all_; }

private:
  std::size_t k_;
  bool all_;
};

/// More classes than these have no bounds on all their intervals: these are as many as the square, and a pass
/// over them costs the cube.
inline constexpr std::size_t most_classes_of_all_intervals = 160;

/// The chain within a tolerance (proofs/README.md, Theorem 17): lower bounds V_ij of the counts
/// q_i + ... + q_j and M_0 of the mass M, raised by steps that every match takes part in until no step raises
/// one. Cost: a pass over the intervals a round; the rounds are few but where classes are narrow.
class TolerantChain {
public:
  /// How a bound came to be.
  enum class Reason : std::uint8_t {
    mass,      ///< the share of M, by which M > 0
    weight,    ///< the share of M, as much as the demanded weight takes
    particles, ///< the share of M, above what the particles of an interval need
    sum        ///< of two intervals, the first of which ends at `of`
  };
  /// A bound of the count of classes i to j.
  struct Raise {
    std::uint32_t i, j;
    Reason reason;
    std::uint32_t of; ///< number of the level for `particles`, class for `sum`
    Integer n;
  };
  /// A bound of M by the particles of classes i to j, as they were known before raise number `before`.
  struct Level {
    std::uint32_t i, j;
    std::size_t before;
  };

  /// \param shares  of the problem; both must outlive this
  /// \param mass  where given, all bounds are of matches with this mass or more, and not to be proved
  /// \pre !shares.contradicts()
  TolerantChain(const TolerantProblem &problem, const ShareClosure &shares, bool all_intervals,
                const Limits &limits, const Watch &watch, const std::optional<Rational> &mass = std::nullopt);
  TolerantChain(const TolerantChain &) = delete;
  TolerantChain &operator=(const TolerantChain &) = delete;

  /// V_ij.
  const Integer &count(std::size_t i, std::size_t j) const { return V_[intervals_.place(i, j)]; }
  /// Every match has at least so many particles.
  const Integer &particles() const { return count(0, problem_.classes() - 1); }
  /// True if no step raises a bound: not so where a limit came first.
  bool complete() const { return complete_; }
  /// True if there is no match: an interval without mass has particles.
  bool contradicts() const { return empty_.has_value(); }
  /// The differences of the bounds of the intervals from the finest class on: the counts of the smallest
  /// match, if they are a match.
  std::vector<Integer> differences() const;

  const TolerantProblem &problem() const { return problem_; }
  const ShareClosure &shares() const { return shares_; }
  const ClassIntervals &intervals() const { return intervals_; }
  /// M_0: every match has this mass or more.
  Rational level() const { return ratio(mass_ * shares_.unit(), share_); }
  /// All raises, in order; empty if they were not to be kept, or are too many for a certificate.
  const std::vector<Raise> &raises() const { return raises_; }
  bool keeps_raises() const { return keeps_raises_; }
  const std::vector<Level> &levels() const { return levels_; }
  /// The interval that shows that there is no match.
  const Level &empty() const { return *empty_; }
  /// The greatest weight of a mass, and sum t_j / c_j over M at most.
  const Rational &heaviest() const { return heaviest_; }
  const Rational &per_mass() const { return per_mass_; }

private:
  void start(const std::optional<Rational> &mass);
  void set_level_from(const Rational &mass);
  void run();
  bool sweep_singles();
  bool raise_singles();
  bool raise_intervals();
  bool raise_intervals_from(std::size_t i);
  bool raise_level();
  bool raise_level_of(std::size_t i, std::size_t j, const Integer &mass);
  Integer masses_of(std::size_t i, std::size_t j) const;
  Integer count_at_level(std::size_t place, const Integer &F, const Integer &missing) const;
  Integer settled_count(std::size_t j) const;
  void raise(std::size_t i, std::size_t j, Integer n, Reason reason, std::uint32_t of);
  void raise_by_level(std::size_t i, std::size_t j, Integer n);
  bool ends();

  const TolerantProblem &problem_;
  const ShareClosure &shares_;
  ClassIntervals intervals_;
  Limits limits_;
  Watch watch_;
  std::vector<Integer> V_, lo_, hi_; ///< at the intervals' places
  Rational heaviest_ = 0, per_mass_ = 0;
  /// M / unit > mass / share, or >= it where not open.
  Integer mass_ = 0, share_ = 1;
  bool is_open_ = true;
  Reason level_reason_ = Reason::mass;
  std::vector<std::size_t> movable_; ///< classes that can still raise the level alone
  std::vector<Raise> raises_;
  std::vector<Level> levels_;
  std::optional<Level> empty_;
  std::uint64_t steps_ = 0;
  bool keeps_raises_, complete_ = false;
};

} // namespace mdm
