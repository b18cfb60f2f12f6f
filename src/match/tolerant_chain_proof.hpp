#pragma once
/// \file
/// The chain within a tolerance as a part of a tree.

#include "match/tolerant_chain.hpp"

namespace mdm {

/// The tree that refutes chain.particles() - 1 particles (Theorem 17). Empty if it is longer than
/// longest_tree, or has more than 8 times as many terms to add up.
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
