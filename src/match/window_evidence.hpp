#pragma once
/// \file
/// The evidence of a search by windows, as short as it can be.

#include "match/mass_window.hpp"
#include "match/watch.hpp"

namespace mdm {

/// The same tree with leaves of windows of as few digits as refute fewer than `particles` particles, or any
/// number, still; and with one such leaf in the place of a split where it serves both of its branches.
/// \param bounds  in force at the root
/// \param watch  once it ends, what is left stays as it is
Tree shortened(const MassWindows &windows, const Tree &tree, const CountBounds &bounds,
               const Integer &particles, const Watch &watch);

/// A tree for fewer particles than this one proves, in less time: one leaf takes the place of a split where
/// it serves both of its branches, and leaves keep their digits.
Tree for_fewer(const MassWindows &windows, const Tree &tree, const CountBounds &bounds,
               const Integer &particles);

} // namespace mdm
