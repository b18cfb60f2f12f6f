#pragma once
/// \file
/// The search for the smallest match within a tolerance, where the chain does not decide.

#include "match/search_tree.hpp"
#include "match/tolerant_match.hpp"
#include "match/window_branching.hpp"

#include <map>
#include <memory>

namespace mdm {

class ExactNode;

/// Branch and bound, the nodes of the least bound first. In windows of the mass programs in double precision
/// choose the splits and the multipliers of bounds, which exact arithmetic proves, and whole counts are
/// looked for and tested exactly. Where they do not serve, and without windows everywhere, nodes are decided
/// exactly.
class TolerantSearch {
public:
  /// \param bounds  on counts, that every match keeps, by the problem or by the chain
  /// \param least  no match has fewer particles
  /// \param best  a match, or nothing; here and after the search
  /// \param mass  where given, the search is by windows of the mass, and this is about the least mass of a match
  TolerantSearch(const TolerantProblem &problem, CountBounds bounds, Integer least,
                 std::optional<TolerantMatch> &best, const Limits &limits, const Watch &watch,
                 const std::optional<Rational> &mass = std::nullopt);
  ~TolerantSearch();

  /// Until the best is the smallest, there is no match for certain, or a limit comes.
  void run();

  /// True if the best is the smallest, or there is none.
  bool is_complete() const;
  /// No match has fewer particles.
  Integer certain() const;
  std::uint64_t nodes() const { return nodes_; }
  /// Refutes fewer than `certain()` particles, with these bounds in force; or any number, where there is no
  /// match. Empty if it is too long.
  Tree tree() const;

private:
  void step_by_windows(SearchTree::Number node);
  bool bound_window(SearchTree::Number node, const WindowPoint &point);
  void look_for_match(const WindowPoint &point);
  bool find_first_match(SearchTree::Number node);
  double limit() const;
  void decide_exactly(SearchTree::Number node);
  bool try_masses(std::vector<Rational> t);
  void set_best(TolerantMatch match);
  std::optional<Integer> most() const;
  bool ends() const;

  const TolerantProblem &problem_;
  CountBounds root_, bounds_;
  std::optional<TolerantMatch> &best_;
  Integer particles_; ///< of the best
  const Limits limits_;
  Watch watch_;
  SearchTree tree_;
  MassWindow window_;
  std::optional<WindowBranching> branching_;
  std::map<SearchTree::Number, WindowPoint> points_; ///< of open nodes whose bounds are theirs
  std::unique_ptr<ExactNode> exact_;
  std::optional<SearchTree::Number> current_; ///< where the walk goes on
  std::uint64_t nodes_ = 0;
  std::uint64_t tries_in_vain_ = 0; ///< to find a better match in a window, since the last that was found ...
  std::uint64_t next_try_ = 0;      ///< ... and the node of the next one
};

} // namespace mdm
