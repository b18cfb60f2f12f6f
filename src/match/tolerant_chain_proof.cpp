// The chain of a tolerance as a tree for the certificate (Theorem 17 (d)). Each raise is a split of N_ij
// whose first branch is a leaf, and the leaf's multiples are those of the theorem's proof: they need the
// bounds that were known, not their values. Of all raises those are written that the last bound comes from,
// found backwards from it; a bound that is a sum of two others needs no split of its own, since a leaf can
// name its parts.

#include "match/tolerant_chain_proof.hpp"

#include "match/leaf_sum.hpp"

#include <algorithm>

namespace mdm {
namespace {

using Condition = TolerantCondition;

void add_conditions(LeafSum &leaf, const TolerantProblem &problem,
                    const std::vector<ShareCondition> &conditions, const Rational &m) {
  for (const ShareCondition &c : conditions) {
    leaf.add(c.condition, c.j, m);
    if (c.condition == Condition::above_lower) // a mass is at least 0: that of its particles
      leaf.add(Condition::least_count, c.j, Rational(m * problem.f(c.j)));
  }
}

/// A proof whose leaves take more terms to add up is given up: it would take more than some seconds.
constexpr std::size_t most_terms = 8 * longest_tree;

/// Looks up where bounds come from, marks what is needed, and writes it.
class Proof {
public:
  explicit Proof(const TolerantChain &chain)
      : chain_(chain), problem_(chain.problem()), raises_of_(chain.intervals().size()),
        is_split_(chain.raises().size(), false), is_known_sum_(chain.raises().size(), false) {
    for (std::size_t r = 0; r < chain.raises().size(); ++r)
      raises_of_[place(chain.raises()[r])].push_back(r);
  }

  std::size_t end() const { return chain_.raises().size(); }

  /// The bound of classes i to j as it was before raise number `before` is needed. A bound that is a sum of
  /// others needs no split of its own, unless one is asked for.
  void need(std::size_t i, std::size_t j, std::size_t before) {
    const std::optional<std::size_t> r = last_raise(i, j, before);
    if (!r)
      return;
    if (is_sum(*r)) {
      if (is_known_sum_[*r])
        return;
      is_known_sum_[*r] = true;
      need(i, chain_.raises()[*r].of, *r);
      need(chain_.raises()[*r].of + 1, j, *r);
    } else {
      is_split_[*r] = true;
    }
  }
  void need_class(std::size_t j) { need(j, j, end()); }
  void need_level(const TolerantChain::Level &level) {
    need(level.i, level.j, level.before);
    Integer f = problem_.f(level.j); // the lower hull
    for (std::size_t b = level.j; b > level.i; --b) {
      if (problem_.f(b - 1) > f)
        need(b - 1, b - 1, level.before);
      else if (problem_.f(b - 1) < f)
        need(b, level.j, level.before);
      f = std::min(f, problem_.f(b - 1));
    }
  }

  /// The splits that are needed, and their leaves; nothing if they are too long.
  std::optional<Tree> splits() {
    std::size_t length = 0; // a leaf has a multiple for each of its classes
    // What a raise needs was raised before it.
    for (std::size_t r = end(); r-- > 0;) {
      if (!is_split_[r])
        continue;
      length += 3 + chain_.raises()[r].j - chain_.raises()[r].i;
      if (length > longest_tree)
        return std::nullopt;
      need_for(r);
    }
    Tree tree;
    for (std::size_t r = 0; r < end(); ++r)
      if (is_split_[r]) {
        const TolerantChain::Raise &raise = chain_.raises()[r];
        tree.push_back({raise.i, raise.j, raise.n, {}});
        tree.push_back(refutation(r));
        if (terms_ > most_terms)
          return std::nullopt;
      }
    return tree;
  }

  /// q_i + ... + q_j >= what was known before raise number `before`.
  void add_least(LeafSum &leaf, std::size_t i, std::size_t j, const Rational &m, std::size_t before) {
    ++terms_;
    const std::optional<std::size_t> r = last_raise(i, j, before);
    if (r && is_sum(*r) && !is_split_[*r]) {
      add_least(leaf, i, chain_.raises()[*r].of, m, *r);
      add_least(leaf, chain_.raises()[*r].of + 1, j, m, *r);
    } else if (r && i < j) {
      leaf.add(Condition::least_sum, i, j, m);
    } else {
      for (std::size_t b = i; b <= j; ++b)
        leaf.add(Condition::least_count, b, m);
    }
  }

  /// h M - what the particles of the level's classes have more than > 0, of their greatest share h.
  LeafSum level(const TolerantChain::Level &of) {
    LeafSum leaf;
    add_above_lower(leaf, of.i, of.j, of.before);
    Integer f = problem_.f(of.j); // the lower hull
    for (std::size_t b = of.j; b > of.i; --b) {
      const Integer &next = problem_.f(b - 1);
      if (next < f)
        add_least(leaf, b, of.j, Rational(f - next), of.before);
      f = std::min(f, next);
      leaf.add(Condition::least_count, b - 1, Rational(next - f));
    }
    add_least(leaf, of.i, of.j, Rational(f), of.before);
    add_conditions(leaf, problem_, chain_.shares().conditions_of_hi(of.i, of.j), 1);
    return leaf;
  }

private:
  std::size_t place(const TolerantChain::Raise &raise) const {
    return chain_.intervals().place(raise.i, raise.j);
  }

  std::optional<std::size_t> last_raise(std::size_t i, std::size_t j, std::size_t before) const {
    const std::vector<std::size_t> &all = raises_of_[chain_.intervals().place(i, j)];
    const auto next = std::lower_bound(all.begin(), all.end(), before);
    return next == all.begin() ? std::nullopt : std::optional<std::size_t>(*std::prev(next));
  }
  bool is_sum(std::size_t r) const { return chain_.raises()[r].reason == TolerantChain::Reason::sum; }

  void need_for(std::size_t r) {
    const TolerantChain::Raise &raise = chain_.raises()[r];
    if (is_sum(r)) {
      need(raise.i, raise.of, r);
      need(raise.of + 1, raise.j, r);
      return;
    }
    Integer F = problem_.F(raise.i); // the upper hull
    for (std::size_t b = raise.i + 1; b <= raise.j; ++b) {
      if (problem_.F(b) > F)
        need(raise.i, b - 1, r);
      else if (problem_.F(b) < F)
        need(b, b, r);
      F = std::max(F, problem_.F(b));
    }
    if (raise.reason == TolerantChain::Reason::particles)
      need_level(chain_.levels()[raise.of]);
  }

  /// The sum of t_b - f_b q_b over classes i to j is above 0, as a bound in force says that there are
  /// particles.
  void add_above_lower(LeafSum &leaf, std::size_t i, std::size_t j, std::size_t before) {
    ++terms_;
    const std::optional<std::size_t> r = last_raise(i, j, before);
    if (r && is_sum(*r) && !is_split_[*r]) {
      add_above_lower(leaf, i, chain_.raises()[*r].of, *r);
      add_above_lower(leaf, chain_.raises()[*r].of + 1, j, *r);
    } else if (r && i < j) {
      leaf.add(Condition::above_lowers, i, j, 1);
    } else {
      for (std::size_t b = i; b <= j; ++b)
        leaf.add(Condition::above_lower, b, 1);
    }
  }

  /// M >= or > the level that a raise is by.
  LeafSum mass(const TolerantChain::Raise &raise) {
    LeafSum leaf;
    const ShareClosure &shares = chain_.shares();
    if (raise.reason == TolerantChain::Reason::mass) {
      leaf.add(Condition::some_mass, 0, 1);
    } else if (raise.reason == TolerantChain::Reason::particles) {
      const TolerantChain::Level &of = chain_.levels()[raise.of];
      leaf.add(level(of), ratio(shares.unit(), shares.hi(of.i, of.j)));
    } else {
      const Rational part = 1 / chain_.per_mass();
      leaf.add(Condition::weight, 0, part);
      for (std::size_t b = 0; b < problem_.classes(); ++b)
        add_conditions(leaf, problem_, shares.conditions_of_lo(b, b),
                       Rational(part * (chain_.heaviest() - problem_.per_mass(b))));
    }
    return leaf;
  }

  /// Fewer than raise.n particles in its classes contradict what was known before.
  TreeNode refutation(std::size_t r) {
    const TolerantChain::Raise &raise = chain_.raises()[r];
    LeafSum leaf;
    const Condition most = raise.i == raise.j ? Condition::most_count : Condition::most_sum;
    if (is_sum(r)) {
      leaf.add(most, raise.i, raise.j, 1);
      add_least(leaf, raise.i, raise.of, 1, r);
      add_least(leaf, raise.of + 1, raise.j, 1, r);
      return leaf.node();
    }
    const ShareClosure &shares = chain_.shares();
    leaf.add(mass(raise), ratio(shares.lo(raise.i, raise.j), shares.unit()));
    add_conditions(leaf, problem_, shares.conditions_of_lo(raise.i, raise.j), 1);
    Integer F = problem_.F(raise.i);
    for (std::size_t b = raise.i; b <= raise.j; ++b) {
      if (problem_.F(b) > F) {
        add_least(leaf, raise.i, b - 1, Rational(problem_.F(b) - F), r);
        F = problem_.F(b);
      }
      leaf.add(Condition::up_to_upper, b, 1);
      leaf.add(Condition::least_count, b, Rational(F - problem_.F(b)));
    }
    leaf.add(most, raise.i, raise.j, Rational(F));
    return leaf.node();
  }

  const TolerantChain &chain_;
  const TolerantProblem &problem_;
  std::vector<std::vector<std::size_t>> raises_of_; ///< at an interval's place, their numbers
  std::vector<bool> is_split_, is_known_sum_;       ///< of raises
  std::size_t terms_ = 0;                           ///< of all leaves so far
};

} // namespace

std::optional<Tree> chain_splits(const TolerantChain &chain, const std::vector<std::size_t> &classes) {
  Proof proof(chain);
  for (const std::size_t j : classes)
    proof.need_class(j);
  return proof.splits();
}

Tree chain_tree(const TolerantChain &chain) {
  Proof proof(chain);
  const std::size_t last = chain.problem().classes() - 1;
  proof.need(0, last, proof.end());
  std::optional<Tree> tree = proof.splits();
  if (!tree)
    return {};
  LeafSum enough;
  proof.add_least(enough, 0, last, 1, proof.end());
  enough.add(TolerantCondition::fewer, 0, 1);
  tree->push_back(enough.node());
  return std::move(*tree);
}

Tree chain_contradiction(const TolerantChain &chain) {
  Proof proof(chain);
  proof.need_level(chain.empty());
  std::optional<Tree> tree = proof.splits();
  if (!tree)
    return {};
  tree->push_back(proof.level(chain.empty()).node());
  return std::move(*tree);
}

Tree share_contradiction(const TolerantProblem &problem, const ShareClosure &shares) {
  LeafSum leaf;
  leaf.add(TolerantCondition::some_mass, 0, shares.weight_of_contradiction());
  add_conditions(leaf, problem, shares.contradiction(), 1);
  return {leaf.node()};
}

Tree tree_of_question() {
  return {{0, 0, 0, {{TolerantCondition::at_least, 0, 1}, {TolerantCondition::fewer, 0, 1}}}};
}

} // namespace mdm
