#pragma once
/// \file
/// Whether a packing is one of a set of discs.

#include "packing/contacts.hpp"
#include "packing/disc_sizes.hpp"

namespace mdm {

/// What is against a packing, in words: nothing if its radii are half the sizes, rounded up to its lattice,
/// each as often; no two discs overlap; all are in the box; each touches its supports, between which its
/// centre is; and the front is where the discs have it. Decided in integers.
std::vector<std::string> packing_objections(const Packing &packing, const PackingContacts &contacts,
                                            const DiscSizes &sizes);

/// What a packing's header says that packing_objections() does not look at, such as `seed 1`: how the discs
/// came to their places.
std::vector<std::string> unverified(const Packing &packing);

} // namespace mdm
