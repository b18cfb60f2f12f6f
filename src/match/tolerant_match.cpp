// The stages of a search within a tolerance, in their order: closure, chain, a first match, the tree. Each
// may end it (README.md here tells how). Invariant: no match has fewer than `least_` particles, and
// result_.best, if there is one, is a match that was tested exactly. It ends when the two meet, when there
// is certainly no match, or at a limit; then what is certain is kept, with the proof of it.

#include "match/tolerant_match.hpp"

#include "match/central_masses.hpp"
#include "match/problem.hpp"
#include "match/simplex.hpp"
#include "match/tolerant_chain_proof.hpp"
#include "match/tolerant_first_match.hpp"
#include "match/tolerant_search.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>

namespace mdm {
namespace {

class Search {
public:
  Search(const TolerantProblem &problem, const Limits &limits, const std::optional<TolerantMatch> &first,
         const Watch &watch)
      : problem_(problem), limits_(limits), watch_(watch.telling([this](Progress &known) { tell(known); })),
        shares_(problem), least_(problem.at_least()) {
    if (first && problem.is_match(first->q, first->t))
      result_.best = first;
  }

  TolerantResult run() {
    try {
      search();
    } catch (const Simplex::Interrupted &) {
      stop();
    }
    return std::move(result_);
  }

private:
  void search() {
    if (shares_.contradicts())
      return end(share_contradiction(problem_, shares_));
    for (const bool all_intervals : {false, true})
      if (!all_intervals || suits_intervals())
        if (is_closed_by(std::make_unique<TolerantChain>(problem_, shares_, all_intervals, limits_, watch_)))
          return;
    constexpr int rounds = 20;
    find_first_match(rounds);
    if (result_.best && needs_no_search())
      return;
    result_.too_large = problem_.table_size() > largest_table;
    if (result_.too_large || interrupted())
      return stop();
    search_tree();
  }

  /// Where what passes is bounded, single classes may need no particles though several together do. Where
  /// classes alone are bounded, windows of the mass show more.
  bool suits_intervals() const {
    constexpr std::size_t most_of_passing = 400;
    const Tolerance &tolerance = problem_.tolerance();
    if (!tolerance.total && tolerance.passing.empty() && suits_windows())
      return false;
    const bool of_passing = !tolerance.total && tolerance.retained.empty();
    return problem_.classes() <= (of_passing ? most_of_passing : most_classes_of_all_intervals);
  }

  void search_tree() {
    const std::optional<Rational> mass =
        suits_windows() ? std::optional<Rational>(least_mass()) : std::nullopt;
    TolerantSearch tree(problem_, root_bounds(), least_, result_.best, limits_, watch_, mass);
    tree_ = &tree;
    try {
      tree.run();
    } catch (const Simplex::Interrupted &) {
      // A limit, as others are.
    }
    tree_ = nullptr;
    result_.nodes = tree.nodes();
    if (tree.is_complete())
      end();
    else
      result_.lower_bound = result_.proved = tree.certain();
    if (limits_.keep_proof)
      keep_tree(tree);
  }

  /// A tree that no certificate can hold is given up: of a search that is not complete, what is certain
  /// without it is proved.
  void keep_tree(const TolerantSearch &search) {
    const bool is_of_chain = result_.best && result_.proved == least_;
    result_.tree = is_of_chain ? tree_of_least() : with_splits(search.tree());
    if (result_.tree.empty() && !result_.complete)
      prove_least();
  }

  /// What the chain knows, or what was asked for if its tree is too long.
  void prove_least() {
    result_.proved = least_;
    result_.tree = tree_of_least();
    if (result_.tree.empty()) {
      result_.proved = problem_.at_least();
      result_.tree = tree_of_question();
    }
  }

  /// True if the chain shows that there is no match, or which is the smallest.
  bool is_closed_by(std::unique_ptr<TolerantChain> chain) {
    if (chain->contradicts()) {
      end(chain->keeps_raises() ? chain_contradiction(*chain) : Tree());
      return true;
    }
    if (!chain_ || chain->particles() > chain_->particles())
      chain_ = std::move(chain);
    least_ = std::max(problem_.at_least(), chain_->particles());
    if (result_.best && needs_no_search())
      return true;
    if (!chain_->complete())
      return false;
    if (problem_.table_size() <= largest_exact_masses)
      return try_counts(chain_->differences()) && needs_no_search();
    find_first_match(1);
    return result_.best && needs_no_search();
  }

  /// Near the chain's bound.
  void find_first_match(int rounds) {
    if (!chain_->complete() || chain_->level() <= 0 || problem_.table_size() > largest_table)
      return;
    const std::optional<Integer> most =
        result_.best ? std::optional<Integer>(total(result_.best->q)) : std::nullopt;
    if (std::optional<TolerantMatch> found =
            first_match(problem_, least_mass(), least_, most, rounds, watch_))
      result_.best = std::move(found);
  }

  /// True if the counts are a match with fewer particles than the best has.
  bool try_counts(const std::vector<Integer> &q) {
    const Integer particles = total(q);
    if (problem_.table_size() > largest_table || particles < problem_.at_least() ||
        (result_.best && particles >= total(result_.best->q)))
      return false;
    std::optional<std::vector<Rational>> t = masses_of(problem_, q, watch_);
    if (t)
      result_.best = TolerantMatch{q, std::move(*t)};
    return t.has_value();
  }

  /// With a tree that was not made by the search.
  void end(Tree tree) {
    end();
    if (limits_.keep_proof && size_of(tree) <= longest_tree)
      result_.tree = std::move(tree);
  }

  static std::size_t size_of(const Tree &tree) {
    return std::accumulate(tree.begin(), tree.end(), std::size_t{0},
                           [](std::size_t n, const TreeNode &node) { return n + 1 + node.leaf.size(); });
  }

  /// The best is the smallest, or there is none.
  void end() {
    result_.complete = true;
    if (result_.best)
      result_.proved = result_.lower_bound = total(result_.best->q);
  }

  /// True if the best has as few particles as every match has for certain.
  bool needs_no_search() {
    const Integer particles = total(result_.best->q);
    if (particles > least_)
      return false;
    end(tree_of_least());
    return true;
  }

  /// Refutes fewer than `least_` particles.
  Tree tree_of_least() const {
    if (least_ == problem_.at_least())
      return tree_of_question();
    return chain_->keeps_raises() ? chain_tree(*chain_) : Tree();
  }

  /// True if a search begins with the chain's bounds of single classes: exact programs do, where the bounds
  /// can be proved if that is asked for. Searches by windows begin with the question alone: their proofs are
  /// shorter.
  bool begins_with_chain() const {
    return !suits_windows() && (chain_->keeps_raises() || !limits_.keep_proof);
  }

  /// The bounds of single classes that every match keeps.
  CountBounds root_bounds() const {
    CountBounds bounds = least_counts(problem_);
    for (std::size_t j = 0; j < problem_.classes() && begins_with_chain(); ++j)
      bounds[j].least = chain_->count(j, j);
    return bounds;
  }

  /// The tree below the splits for the chain's bounds that its leaves use; empty if it is too long.
  Tree with_splits(Tree tree) const {
    if (tree.empty() || !begins_with_chain())
      return tree;
    std::vector<std::size_t> used;
    for (const TreeNode &node : tree)
      for (const Multiple &m : node.leaf)
        if (m.condition == TolerantCondition::least_count || m.condition == TolerantCondition::above_lower)
          used.push_back(m.j);
    std::optional<Tree> all = chain_splits(*chain_, used);
    if (!all)
      return {};
    all->insert(all->end(), std::make_move_iterator(tree.begin()), std::make_move_iterator(tree.end()));
    return size_of(*all) <= longest_tree ? std::move(*all) : Tree();
  }

  /// Exact programs alone are quickest where they are small.
  bool suits_windows() const { return problem_.table_size() > exact_table; }

  /// About the least mass of a match.
  Rational least_mass() const {
    return chain_->level() > 0 ? chain_->level() : Rational(problem_.F(problem_.classes() - 1));
  }

  Integer certain() const { return tree_ ? tree_->certain() : least_; }

  /// Ends at a limit before the search.
  void stop() {
    result_.lower_bound = result_.proved = least_;
    if (limits_.keep_proof)
      prove_least();
  }

  void tell(Progress &known) const {
    known.steps = tree_ ? tree_->nodes() : 0;
    known.lower_bound = certain();
    if (result_.best)
      known.particles = total(result_.best->q);
  }

  bool interrupted() const {
    return watch_.ends() || limits_.node_limit == 0 || (limits_.at_most && least_ > *limits_.at_most) ||
           (result_.best && is_good_enough(total(result_.best->q)));
  }

  /// The best has as few particles as are asked for.
  bool is_good_enough(const Integer &particles) const {
    return (limits_.enough && particles <= *limits_.enough) || limits_.is_close(particles, least_);
  }

  const TolerantProblem &problem_;
  const Limits limits_;
  const Watch watch_;
  ShareClosure shares_;
  std::unique_ptr<TolerantChain> chain_;
  const TolerantSearch *tree_ = nullptr;
  Integer least_; ///< no match has fewer particles
  TolerantResult result_;
};

} // namespace

TolerantResult tolerant_match(const TolerantProblem &problem, const Limits &limits,
                              const std::optional<TolerantMatch> &first, const Watch &watch) {
  return Search(problem, limits, first, watch).run();
}

TolerantResult tolerant_match(const TolerantProblem &problem, const Limits &limits,
                              const std::optional<TolerantMatch> &first) {
  return tolerant_match(problem, limits, first, Watch(limits.deadline));
}

} // namespace mdm
