// The tree of a search within a tolerance (Theorems 14 and 20; README.md here). What comes in are bounds on
// counts that every match keeps, and maybe a match; what goes out is the smallest match or that there is
// none, with a tree that proves it, or at a limit both bounds.
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
#include "match/tolerant_relaxation.hpp"
#include "match/window_evidence.hpp"

#include <algorithm>
#include <cmath>

namespace mdm {
namespace {

/// About how many particles the classes have in a match, at least 1.
std::vector<double> typical_counts(const TolerantProblem &problem, const CountBounds &bounds, double mass) {
  std::vector<double> counts;
  for (std::size_t j = 0; j < problem.classes(); ++j) {
    const double share = near(problem.target()[j]) * mass / near(problem.F(j));
    counts.push_back(std::max({1.0, share, near(bounds.classes[j].least)}));
  }
  return counts;
}

/// A split of the count of classes i to j, at a value that is no whole number.
struct Candidate {
  std::size_t i, j;
  double value;
  double down, up; ///< by how much the number of particles rises at least
};

/// By how much both branches are above the node: the product rule of reliability branching (Achterberg 2007).
/// A branch that gains nothing has a least part, so that what the other one gains still counts.
double merit(const Candidate &c, double room) {
  constexpr double least = 1e-6;
  const auto rise = [&](double by) { return std::max(std::min(by, room), least); };
  return rise(c.down) * rise(c.up);
}

/// The count of some classes together.
struct Sum {
  TolerantRelaxation::Row row;
  double count = 0, scale = 0;

  void add(const TolerantRelaxation &relaxation, std::size_t j) {
    row.add(relaxation, j);
    count += relaxation.count(j);
    scale += relaxation.typical(j);
  }
};

/// With no more numbers in its table the exact program is worth its time where doubles find nothing.
constexpr std::size_t small_table = 4096;

/// What a count may be wrong by, relative to typical counts, and at most: a count that is nearer to a whole
/// number is one, and is not split.
constexpr double relative_noise = 1e-9, most_noise = 0.05;

/// A bound of the chain, and by which part of itself a sum is too small.
struct Cut {
  std::size_t i, j;
  double missing;
};

} // namespace

struct TolerantSearch::Steered {
  TolerantRelaxation relaxation;
  BoundMaker bound_maker;

  Steered(const TolerantProblem &problem, const std::vector<double> &typical, const Watch &watch)
      : relaxation(problem, typical, watch), bound_maker(problem) {}

  /// Sums that are below the chain's bounds, the worst first.
  std::vector<Cut> violated(const TolerantChain &chain, const CountBounds &known) const {
    std::vector<Cut> cuts;
    const std::size_t k = chain.problem().classes();
    if (known.sums.size() >= 2 * k)
      return cuts;
    for (std::size_t i = 0; i < k; ++i) {
      double sum = 0;
      for (std::size_t j = i; j < k; ++j) {
        sum += relaxation.count(j);
        if (i == j || !chain.intervals().has(i, j))
          continue;
        const double missing = near(chain.count(i, j)) - sum;
        if (missing > 1e-6 * (1 + sum) && known.sums.count({i, j}) == 0)
          cuts.push_back({i, j, missing / (1 + sum)});
      }
    }
    std::sort(cuts.begin(), cuts.end(), [](const Cut &a, const Cut &b) { return a.missing > b.missing; });
    return cuts;
  }

  std::optional<Candidate> best_split(const TolerantProblem &problem, const CountBounds &bounds,
                                      double room) const {
    const std::size_t k = problem.classes();
    std::optional<Candidate> best;
    const auto look = [&](std::size_t i, std::size_t j, const Sum &sum) {
      const double whole = std::floor(sum.count), part = sum.count - whole;
      const double noise = std::min(sum.scale * relative_noise, most_noise);
      if (!(part >= noise && part <= 1 - noise) || !bounds.is_inside(i, j, Integer(whole + 1)))
        return;
      const Candidate c{i, j, sum.count, part * sum.row.price(relaxation, false),
                        (1 - part) * sum.row.price(relaxation, true)};
      if (!best || merit(c, room) > merit(*best, room))
        best = c;
    };
    Sum from_finest, from_coarsest;
    for (std::size_t j = 0; j < k; ++j) {
      const std::size_t i = k - 1 - j;
      from_finest.add(relaxation, j);
      from_coarsest.add(relaxation, i);
      if (j > 0)
        look(0, j, from_finest);
      if (j > 0 && i > 0)
        look(i, k - 1, from_coarsest);
      Sum single;
      single.add(relaxation, j);
      look(j, j, single);
    }
    return best;
  }
};

TolerantSearch::TolerantSearch(const TolerantProblem &problem, CountBounds bounds, Integer least,
                               const TolerantChain *chain, std::optional<TolerantMatch> &best,
                               const Limits &limits, const Watch &watch, const std::optional<Rational> &mass)
    : problem_(problem), root_(std::move(bounds)), chain_(chain), best_(best), limits_(limits), watch_(watch),
      tree_(std::move(least), limits.keep_proof) {
  if (best_)
    particles_ = total(best_->q);
  if (mass)
    branching_.emplace(problem, *mass);
}

void TolerantSearch::set_best(TolerantMatch match) {
  particles_ = total(match.q);
  best_ = std::move(match);
}

TolerantSearch::~TolerantSearch() = default;

TolerantSearch::Steered &TolerantSearch::steered() {
  if (!steered_) {
    double mass = 0;
    for (const Rational &t : best_->t)
      mass += near(t);
    steered_ = std::make_unique<Steered>(problem_, typical_counts(problem_, root_, mass), watch_);
  }
  return *steered_;
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
      step(node);
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
    tree_.split(node, split->j, split->j, split->v);
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

/// Closes a node, or splits it and goes on with the child that seems better.
void TolerantSearch::step(SearchTree::Number node) {
  for (;;) {
    if (!best_ || problem_.table_size() <= exact_table)
      return decide_exactly(node);
    if (watch_.ends())
      return;
    const bool is_feasible = bound_node(node);
    if (tree_.bound(node) > *most())
      return tree_.close(node);
    if (!is_feasible && problem_.table_size() <= small_table)
      return decide_exactly(node);
    if (!is_feasible || !add_cuts())
      break;
  }
  const double room = near(*most()) + 1 - steered().relaxation.particles();
  const std::optional<Candidate> c = steered().best_split(problem_, bounds_, room);
  if (!c)
    return decide_exactly(node);
  const SearchTree::Number first = tree_.split(node, c->i, c->j, Integer(std::floor(c->value) + 1));
  current_ = c->down <= c->up ? first : first + 1;
}

/// Makes the node's bound as good as the linear program has it. False if there seems to be nothing of
/// interest, and the bound does not show it.
bool TolerantSearch::bound_node(SearchTree::Number node) {
  TolerantRelaxation &relaxation = steered().relaxation;
  relaxation.set(bounds_, most());
  for (const bool again : {false, true}) {
    if (again)
      relaxation.refresh();
    const bool is_feasible = relaxation.minimise();
    CertainBound found = steered().bound_maker.bound(bounds_, relaxation.steering());
    if (!found.particles) {
      // Its leaf does not count particles.
      tree_.raise(node, particles_, std::move(found.leaf));
      return true;
    }
    tree_.raise(node, *found.particles, std::move(found.leaf));
    if (is_feasible || tree_.bound(node) > *most())
      return true;
  }
  return false;
}

/// Takes bounds of the chain that the program's counts do not keep. True if there are some.
bool TolerantSearch::add_cuts() {
  if (!chain_)
    return false;
  constexpr std::size_t most_cuts = 10;
  std::vector<Cut> cuts = steered().violated(*chain_, root_);
  if (cuts.size() > most_cuts)
    cuts.resize(most_cuts);
  for (const Cut &cut : cuts) {
    const Integer &least = chain_->count(cut.i, cut.j);
    for (CountBounds *bounds : {&root_, &bounds_}) {
      CountBound &bound = bounds->of(cut.i, cut.j);
      bound.least = std::max(bound.least, least);
    }
  }
  return !cuts.empty();
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
      current_ = tree_.split(node, j, j, v);
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
  return branching_ ? shortened(branching_->windows(), tree, root_, certain()) : tree;
}

} // namespace mdm
