// The tree of a search within a tolerance (Theorems 14 and 20; README.md here). What comes in is a
// question, how many particles every match has at least, and maybe a match; what goes out is the smallest
// match or that there is none, with a tree that proves it, or at a limit both bounds.
//
// Branch and bound. Each open node is a box of counts and a window of the mass, with a bound on the
// particles of every match in it that exact numbers have proved. Invariant: every match with fewer
// particles than the best is in an open node. The node with the least bound is taken: it is bounded anew by
// what doubles propose and exact arithmetic proves, closed if the bound leaves nothing better than the
// best, or split so that the two children hold all its matches. In windows whole counts are looked for and
// tested exactly, which may give a better best.
//
// It ends because the best bounds all counts: in a node in which every count is fixed, which exact numbers
// decide, nothing can be split (Theorem 13). The search stops when the least bound of all open nodes has
// reached the best.

#include "match/tolerant_search.hpp"

#include "match/exact_node.hpp"
#include "match/near.hpp"
#include "match/problem.hpp"
#include "match/window_evidence.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {

TolerantSearch::TolerantSearch(const TolerantProblem &problem, CountBounds bounds, Integer least,
                               std::optional<TolerantMatch> &best, const Limits &limits, const Watch &watch,
                               const std::optional<Rational> &mass)
    : problem_(problem), root_(std::move(bounds)), best_(best), limits_(limits), watch_(watch),
      tree_(std::move(least), limits.keep_proof) {
  if (best_)
    particles_ = total(best_->q);
  if (mass)
    branching_.emplace(problem, *mass);
}

TolerantSearch::~TolerantSearch() = default;

void TolerantSearch::set_best(TolerantMatch match) {
  particles_ = total(match.q);
  best_ = std::move(match);
}

/// The most particles that are of interest.
std::optional<Integer> TolerantSearch::most() const {
  if (!best_)
    return std::nullopt;
  const Integer close = limits_.gap ? floor(Rational(*limits_.gap * particles_)) : Integer(0);
  return Integer(particles_ - 1 - close);
}

Integer TolerantSearch::certain() const {
  const std::optional<Integer> bound = tree_.least_bound();
  if (!best_)
    return bound.value_or(Integer(1));
  return bound ? std::min(*bound, particles_) : particles_;
}

bool TolerantSearch::is_complete() const {
  return best_ ? certain() == particles_ : !tree_.has_open();
}

bool TolerantSearch::ends() const {
  return (limits_.node_limit && nodes_ >= *limits_.node_limit) || watch_.ends() ||
         (limits_.at_most && certain() > *limits_.at_most) ||
         (best_ &&
          ((limits_.enough && particles_ <= *limits_.enough) || limits_.is_close(particles_, certain())));
}

void TolerantSearch::run() {
  while (tree_.has_open() && !ends()) {
    const SearchTree::Number node = current_ ? *current_ : *tree_.next();
    current_.reset();
    ++nodes_;
    bounds_ = root_;
    window_ = {};
    tree_.apply_splits(node, bounds_, window_);
    if (branching_)
      step_by_windows(node);
    else
      decide_exactly(node);
  }
}

/// A match is of interest only if it has fewer particles.
double TolerantSearch::limit() const {
  return best_ ? near(*most()) + 1 : std::numeric_limits<double>::infinity();
}

/// Bounds a node, which is split if its bound remains the least one.
void TolerantSearch::step_by_windows(SearchTree::Number node) {
  auto known = points_.find(node);
  if (known == points_.end()) {
    const WindowPoint found = branching_->minimise(window_, bounds_, limit(), 0);
    if (bound_window(node, found))
      return;
    known = points_.emplace(node, found).first;
    if (*tree_.next() != node)
      return;
  }
  const WindowPoint point = std::move(known->second);
  points_.erase(known);
  if (point.exists())
    look_for_match(point);
  if (!best_ && !find_first_match(node))
    return;
  if (tree_.bound(node) > *most())
    return tree_.close(node);
  const std::optional<WindowBranching::Split> split =
      branching_->best_split(window_, bounds_, point, limit());
  if (!split)
    decide_exactly(node);
  else if (split->mass)
    tree_.split(node, *split->mass);
  else
    tree_.split(node, split->j, split->v);
}

/// Near the middle of the window. The more often nothing has been found, the more windows are passed over.
void TolerantSearch::look_for_match(const WindowPoint &point) {
  constexpr std::uint64_t patience = 16;
  if (best_ && nodes_ < next_try_)
    return;
  if (std::optional<TolerantMatch> found =
          branching_->match(window_, bounds_, limit(), point.prices.excess)) {
    set_best(std::move(*found));
    tries_in_vain_ = 0;
  } else {
    ++tries_in_vain_;
  }
  next_try_ = nodes_ + 1 + tries_in_vain_ / patience;
}

/// Exactly. Closes the node if there is none.
bool TolerantSearch::find_first_match(SearchTree::Number node) {
  if (!exact_)
    exact_ = std::make_unique<ExactNode>(problem_, watch_);
  if (exact_->find(bounds_, std::nullopt))
    return try_masses(exact_->masses());
  tree_.close_without_match(node, exact_->leaf());
  return false;
}

/// True if that closes the node.
bool TolerantSearch::bound_window(SearchTree::Number node, const WindowPoint &point) {
  const WindowPrices prices = point.exact_prices();
  const WindowVerdict found = branching_->windows().verdict(window_, bounds_, prices);
  if (found.is_refuted) {
    tree_.close_without_match(node, branching_->windows().leaf(prices));
    return true;
  }
  tree_.raise(node, found.particles, branching_->windows().leaf(prices));
  if (!best_ || tree_.bound(node) <= *most())
    return false;
  tree_.close(node);
  return true;
}

/// As few particles as can hold the masses t; then, where more are asked for, as many more as can, from the
/// finest class on.
static std::vector<Integer> particles_of(const TolerantProblem &problem, const std::vector<Rational> &t) {
  std::vector<Integer> q;
  for (std::size_t j = 0; j < t.size(); ++j)
    q.push_back(std::max(problem.least(j), ceil(Rational(t[j] / problem.F(j)))));
  Integer missing = problem.at_least() - total(q);
  for (std::size_t j = 0; j < t.size() && missing > 0; ++j) {
    if (t[j] == 0)
      continue;
    const Integer &f = problem.f(j);
    const Integer room = f == 0 ? missing : Integer(ceil(Rational(t[j] / f)) - 1 - q[j]);
    const Integer more = std::min(room, missing);
    if (more <= 0)
      continue;
    q[j] += more;
    missing -= more;
  }
  return q;
}

/// True if the masses, or twice or more times as much, in as few particles as can be, are a match with fewer
/// particles than the best has. With enough of it, a mass above 0 can be had in a whole number of particles
/// (Theorem 13): where there is no best yet, this is one.
bool TolerantSearch::try_masses(std::vector<Rational> t) {
  for (;;) {
    std::vector<Integer> q = particles_of(problem_, t);
    if (best_ && total(q) > *most())
      return false;
    if (problem_.is_match(q, t)) {
      set_best({std::move(q), std::move(t)});
      return true;
    }
    for (Rational &mass : t)
      mass *= 2;
  }
}

void TolerantSearch::decide_exactly(SearchTree::Number node) {
  if (!exact_)
    exact_ = std::make_unique<ExactNode>(problem_, watch_);
  ExactNode &exact = *exact_;
  while (exact.find(bounds_, most()))
    if (!try_masses(exact.masses())) {
      const auto [j, v] = exact.split();
      current_ = tree_.split(node, j, v);
      return;
    }
  TreeNode leaf = exact.leaf();
  const bool counts = std::any_of(leaf.leaf.begin(), leaf.leaf.end(),
                                  [](const Multiple &m) { return m.condition == TolerantCondition::fewer; });
  if (!counts)
    return tree_.close_without_match(node, std::move(leaf));
  tree_.raise(node, Integer(*most() + 1), std::move(leaf));
  tree_.close(node);
}

Tree TolerantSearch::tree() const {
  const Tree tree = tree_.tree(certain(), longest_tree);
  return branching_ ? shortened(branching_->windows(), tree, root_, certain(), watch_) : tree;
}

} // namespace mdm
