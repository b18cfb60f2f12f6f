#pragma once
/// \file
/// The chain within a tolerance as a part of a tree.

#include "match/tolerant_chain.hpp"

namespace mdm {

/// Splits for the chain's bounds on these classes (Theorem 17), and for those that they come from, each with
/// a leaf for its first branch: what follows is the rest of a tree in which these bounds are in force.
/// Nothing if they are longer than longest_tree, or have more than 8 times as many terms to add up.
/// \pre chain.keeps_raises()
std::optional<Tree> chain_splits(const TolerantChain &chain, const std::vector<std::size_t> &classes);

/// The tree that refutes chain.particles() - 1 particles; empty if it is too long, as above.
/// \pre chain.keeps_raises()
Tree chain_tree(const TolerantChain &chain);

/// The tree that refutes any number of particles.
/// \pre chain.keeps_raises() and chain.contradicts()
Tree chain_contradiction(const TolerantChain &chain);

/// The tree that refutes any number of particles, where no shares meet all bounds.
/// \pre shares.contradicts()
Tree share_contradiction(const TolerantProblem &problem, const ShareClosure &shares);

/// Refutes fewer particles than were asked for at least, which nothing has to show.
Tree tree_of_question();

} // namespace mdm
