#include "match/tolerant_match.hpp"

#include "match/central_masses.hpp"
#include "match/leaf_sum.hpp"
#include "match/problem.hpp"
#include "match/simplex.hpp"
#include "match/tolerant_chain_proof.hpp"
#include "match/tolerant_climb.hpp"

#include <algorithm>
#include <iterator>
#include <memory>
#include <numeric>

namespace mdm {
namespace {

const Infinitesimal strictly_positive{0, 1};

/// The time for the proof of a bound after a limit has ended the search.
constexpr std::chrono::seconds proof_time{2};

Infinitesimal exactly(const Rational &r) {
  return {r, 0};
}

/// Least integer v > x - 1 that is not x: x < v is the branch below, where x is no integer.
Integer next_integer(const Infinitesimal &x) {
  const Integer whole = floor(x.value);
  return x.value == whole && x.tiny < 0 ? whole : Integer(whole + 1);
}

bool is_integer(const Infinitesimal &x) {
  return x.tiny == 0 && denominator(x.value) == 1;
}

class Search {
public:
  Search(const TolerantProblem &problem, const Limits &limits, const std::optional<TolerantMatch> &first,
         const Watch &watch)
      : problem_(problem), limits_(limits), watch_(watch.telling([this](Progress &known) { tell(known); })),
        program_(problem.variables(), watch_), shares_(problem), least_(problem.at_least()), bound_(least_) {
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
      if (!all_intervals || problem_.classes() <= most_classes_of_all_intervals)
        if (is_closed_by(std::make_unique<TolerantChain>(problem_, shares_, all_intervals, limits_, watch_)))
          return;
    find_first_match();
    if (result_.best && needs_no_search())
      return;
    result_.too_large = problem_.table_size() > largest_table;
    if (result_.too_large || interrupted())
      return stop();
    set_up();
    for (bool open = true; open;) {
      if (interrupted())
        return stop();
      ++result_.nodes;
      if (program_.find(count_)) {
        program_.minimise(count_);
        bound_ = std::max(bound_, ceil_of(program_.value(count_)));
        if (!try_rounding()) // else the same node again, with a lower cutoff
          branch();
        else if (needs_no_search())
          return;
      } else {
        add_leaf();
        open = backtrack();
      }
    }
    add_splits();
    end();
  }

  /// True if the chain shows that there is no match, or which is the smallest.
  bool is_closed_by(std::unique_ptr<TolerantChain> chain) {
    if (chain->contradicts()) {
      end(chain->keeps_raises() ? chain_contradiction(*chain) : Tree());
      return true;
    }
    if (!chain_ || chain->particles() > chain_->particles())
      chain_ = std::move(chain);
    least_ = bound_ = std::max(problem_.at_least(), chain_->particles());
    if (result_.best && needs_no_search())
      return true;
    return chain_->complete() && try_counts(chain_->differences()) && needs_no_search();
  }

  /// Near the chain's bound.
  void find_first_match() {
    if (!chain_->complete() || chain_->level() <= 0 || problem_.table_size() > largest_table)
      return;
    const std::optional<Integer> most =
        result_.best ? std::optional<Integer>(total(result_.best->q)) : std::nullopt;
    std::optional<TolerantMatch> found = neighbouring_match(*chain_, watch_);
    if (!found)
      found = climbed_match(*chain_, most, watch_);
    if (found && (!most || total(found->q) < *most))
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
      return {{0, 0, 0, {{TolerantCondition::at_least, 0, 1}, {TolerantCondition::fewer, 0, 1}}}};
    return chain_->keeps_raises() ? chain_tree(*chain_) : Tree();
  }

  void set_up() {
    row_of_.clear();
    strict_.clear();
    for (const LinearRow &row : problem_.rows())
      add_row(row);
    for (std::size_t j = 0; j < problem_.classes(); ++j)
      program_.set_lower(j, exactly(Rational(has_chain() ? chain_->count(j, j) : problem_.least(j))));
    if (has_chain())
      add_sums();
    for (std::size_t p = 2 * problem_.classes(); p < problem_.variables(); ++p)
      program_.set_lower(p, exactly(0));
    for (std::size_t j = 0; j < problem_.classes(); ++j)
      set_strictness(j);
    if (result_.best)
      set_cutoff();
  }

  /// True if the chain's bounds are rows of the program: they can be proved, if that is asked for.
  bool has_chain() const { return chain_->keeps_raises() || !limits_.keep_proof; }

  /// The chain's bounds of several classes that are no sums of others.
  void add_sums() {
    const ClassIntervals &intervals = chain_->intervals();
    for (std::size_t i = 0; i < problem_.classes(); ++i)
      for (std::size_t j = i + 1; j < problem_.classes(); ++j)
        if (intervals.has(i, j) && !is_sum_of_parts(i, j)) {
          std::vector<std::pair<std::size_t, Rational>> counts;
          for (std::size_t b = i; b <= j; ++b)
            counts.emplace_back(b, 1);
          const std::size_t form = program_.add_form(counts);
          row_of_.push_back({TolerantCondition::least_sum, j, 0, i});
          program_.set_lower(form, exactly(Rational(chain_->count(i, j))));
        }
  }
  bool is_sum_of_parts(std::size_t i, std::size_t j) const {
    const ClassIntervals &intervals = chain_->intervals();
    for (std::size_t b = i; b < j; ++b)
      if (intervals.has(i, b) && intervals.has(b + 1, j) &&
          chain_->count(i, b) + chain_->count(b + 1, j) == chain_->count(i, j))
        return true;
    return false;
  }

  /// Puts the splits for the chain's bounds that leaves use before the tree.
  void add_splits() {
    if (result_.tree.empty() || !has_chain())
      return;
    std::vector<ClassInterval> used;
    for (const TreeNode &node : result_.tree)
      for (const Multiple &m : node.leaf)
        if (m.condition == TolerantCondition::least_sum)
          used.push_back({m.i, m.j});
        else if (m.condition == TolerantCondition::least_count ||
                 m.condition == TolerantCondition::above_lower)
          used.push_back({m.j, m.j});
    Tree tree = chain_splits(*chain_, used);
    if (size_of(tree) + tree_size_ > longest_tree)
      return Tree().swap(result_.tree);
    tree.insert(tree.end(), std::make_move_iterator(result_.tree.begin()),
                std::make_move_iterator(result_.tree.end()));
    result_.tree = std::move(tree);
  }

  /// A certain bound: every match is the best, or in a subtree that is still open.
  Integer certain() const {
    Integer least = bound_;
    for (const Pending &p : pending_)
      if (!p.second)
        least = std::min(least, p.bound);
    if (result_.best) // which may lie outside the subtrees that are open
      least = std::min(least, total(result_.best->q));
    return least;
  }

  /// Ends the search at a limit, with a proof of what is certain.
  void stop() {
    result_.lower_bound = certain();
    if (!limits_.keep_proof || result_.lower_bound == least_ || !refute_below(result_.lower_bound)) {
      result_.proved = least_;
      result_.tree = tree_of_least();
      return;
    }
    result_.proved = result_.lower_bound;
    if (result_.best && total(result_.best->q) == result_.lower_bound)
      end();
  }

  /// Makes leaves of all open nodes: their linear programs have a match with fewer than `bound` particles no
  /// more than those above them. False if it takes too long, or the tree is too long to be kept.
  bool refute_below(const Integer &bound) {
    if (tree_size_ > longest_tree)
      return false;
    // An interrupted program is of no use.
    program_ = Simplex(problem_.variables(), Watch(std::chrono::steady_clock::now() + proof_time));
    set_up();
    for (const Pending &p : pending_)
      enter(p);
    program_.set_upper(count_, exactly(Rational(Integer(bound - 1))));
    try {
      for (bool open = true; open; open = backtrack()) {
        if (program_.find(count_))
          return false;
        add_leaf();
      }
    } catch (const Simplex::Interrupted &) {
      return false;
    }
    add_splits();
    return !result_.tree.empty();
  }

  void tell(Progress &known) const {
    known.steps = result_.nodes;
    known.lower_bound = certain();
    if (result_.best)
      known.particles = total(result_.best->q);
  }

  /// A split whose second subtree is still to come.
  struct Pending {
    std::size_t j;
    Integer v;
    Simplex::Bound upper; ///< of q_j before the split
    Simplex::Bound lower;
    Integer bound;       ///< no match in either subtree has fewer particles
    bool second = false; ///< the walk is in the second subtree
  };

  void add_row(const LinearRow &row) {
    const std::size_t form = program_.add_form(row.terms);
    row_of_.push_back({row.condition, row.j, 0});
    if (row.condition == TolerantCondition::above_lower)
      strict_.push_back(form);
    else
      program_.set_lower(form, row.condition == TolerantCondition::some_mass ? strictly_positive
                                                                             : exactly(row.constant));
    if (row.condition == TolerantCondition::at_least)
      count_ = form;
  }

  /// t_j > f_j q_j where q_j >= 1 in this branch.
  void set_strictness(std::size_t j) {
    const bool strict = !(program_.lower(j)->value < 1);
    program_.set_lower(strict_[j], strict ? strictly_positive : exactly(0));
  }

  static Integer ceil_of(const Infinitesimal &x) {
    const Integer whole = floor(x.value);
    return x.value == whole && !(x.tiny > 0) ? whole : Integer(whole + 1);
  }

  bool interrupted() const {
    return (limits_.node_limit && result_.nodes >= *limits_.node_limit) || watch_.ends() ||
           (limits_.at_most && certain() > *limits_.at_most) ||
           (result_.best && is_good_enough(total(result_.best->q)));
  }

  /// The best has as few particles as are asked for.
  bool is_good_enough(const Integer &particles) const {
    return (limits_.enough && particles <= *limits_.enough) || limits_.is_close(particles, certain());
  }

  /// The contradiction of the program's bounds as multiples of conditions, cleared of denominators.
  void add_leaf() {
    std::vector<Rational> multipliers;
    TreeNode node;
    for (const Simplex::Term &term : program_.conflict()) {
      multipliers.push_back(term.multiplier);
      node.leaf.push_back(condition_of(term));
    }
    set_multipliers(node, multipliers);
    keep(std::move(node));
  }

  /// A tree that no certificate can hold is given up.
  void keep(TreeNode node) {
    tree_size_ += 1 + node.leaf.size();
    if (limits_.keep_proof && tree_size_ <= longest_tree)
      result_.tree.push_back(std::move(node));
    else
      Tree().swap(result_.tree);
  }

  Multiple condition_of(const Simplex::Term &term) const {
    const std::size_t k = problem_.classes();
    if (term.variable < k)
      return {term.is_upper ? TolerantCondition::most_count : TolerantCondition::least_count, term.variable,
              0};
    if (term.variable < problem_.variables())
      return {TolerantCondition::excess_sign, term.variable - 2 * k, 0};
    const Multiple &row = row_of_[term.variable - problem_.variables()];
    return {term.is_upper ? TolerantCondition::fewer : row.condition, row.j, 0, row.i};
  }

  /// Undoes branches up to the last split whose second subtree is to come, and enters that. False if there is
  /// none.
  bool backtrack() {
    while (!pending_.empty() && pending_.back().second) {
      const Pending &p = pending_.back();
      program_.set_lower(p.j, p.lower);
      set_strictness(p.j);
      pending_.pop_back();
    }
    if (pending_.empty())
      return false;
    Pending &p = pending_.back();
    p.second = true;
    bound_ = p.bound;
    program_.set_upper(p.j, p.upper);
    enter(p);
    return true;
  }

  /// Sets the bound of the subtree that the walk is in.
  void enter(const Pending &p) {
    if (p.second) {
      program_.set_lower(p.j, exactly(Rational(p.v)));
      set_strictness(p.j);
    } else {
      program_.set_upper(p.j, exactly(Rational(Integer(p.v - 1))));
    }
  }

  /// Splits at the coarsest class whose count is no integer; where all are, at one that holds no mass above
  /// its lower bound and could be empty.
  void branch() {
    for (std::size_t j = problem_.classes(); j-- > 0;)
      if (!is_integer(program_.value(j)))
        return split(j, next_integer(program_.value(j)));
    for (std::size_t j = problem_.classes(); j-- > 0;)
      if (program_.lower(j)->value < 1 && program_.value(j).value >= 1)
        return split(j, 1);
  }

  void split(std::size_t j, const Integer &v) {
    keep({j, j, v, {}});
    pending_.push_back({j, v, program_.upper(j), program_.lower(j), bound_});
    enter(pending_.back());
  }

  /// As few particles as can hold the masses t; then, where more are asked for, as many more as can, from the
  /// finest class on.
  std::vector<Integer> particles_of(const std::vector<Rational> &t) const {
    std::vector<Integer> q;
    for (std::size_t j = 0; j < t.size(); ++j)
      q.push_back(std::max(problem_.least(j), ceil(Rational(t[j] / problem_.F(j)))));
    Integer missing = problem_.at_least() - total(q);
    for (std::size_t j = 0; j < t.size() && missing > 0; ++j) {
      if (t[j] == 0)
        continue;
      const Integer &f = problem_.f(j);
      const Integer room = f == 0 ? missing : Integer(ceil(Rational(t[j] / f)) - 1 - q[j]);
      const Integer more = std::min(room, missing);
      if (more <= 0)
        continue;
      q[j] += more;
      missing -= more;
    }
    return q;
  }

  void improve(TolerantMatch match) {
    result_.best = std::move(match);
    set_cutoff();
  }

  /// Fewer particles than the best has.
  void set_cutoff() { program_.set_upper(count_, exactly(Rational(Integer(total(result_.best->q) - 1)))); }

  /// True if the masses of the program, or twice or more times as much, in as few particles as can be, are a
  /// match with fewer particles than the best. With enough of it, a mass above 0 can be had in a whole number
  /// of particles (Theorem 13): where there is no best yet, this is one.
  bool try_rounding() {
    TolerantMatch match{{}, program_.concrete_values(problem_.classes(), 2 * problem_.classes())};
    for (;;) {
      match.q = particles_of(match.t);
      if (result_.best && total(match.q) >= total(result_.best->q))
        return false;
      if (problem_.is_match(match.q, match.t)) {
        improve(std::move(match));
        return true;
      }
      for (Rational &t : match.t)
        t *= 2;
    }
  }

  const TolerantProblem &problem_;
  const Limits limits_;
  const Watch watch_;
  Simplex program_;
  ShareClosure shares_;
  std::unique_ptr<TolerantChain> chain_;
  std::vector<Multiple> row_of_;    ///< condition of each form
  std::vector<std::size_t> strict_; ///< forms of above_lower
  std::size_t count_ = 0;           ///< form of at_least
  Integer least_;                   ///< no match has fewer particles
  Integer bound_;                   ///< no match of this node has
  std::vector<Pending> pending_;
  std::size_t tree_size_ = 0; ///< nodes and multiples
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
