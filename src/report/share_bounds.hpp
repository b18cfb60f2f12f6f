#pragma once
/// \file
/// The shares of a sample against bounds on them.

#include "gradation/description.hpp"

#include <mdm/match/tolerance.hpp>

#include <optional>
#include <string>

namespace mdm {

/// The outcome of a comparison.
struct BoundsVerdict {
  std::optional<bool> holds; ///< nothing: the enclosures of shares do not tell
  std::string reason;        ///< all bounds that are broken, else all that are open; empty if all hold
};

/// True if all shares that e found lie within the bounds, which are closed.
/// \param digits of percents in the reason
BoundsVerdict check_bounds(const Tolerance &bounds, const MatchError &e, const Gradation &g, unsigned digits);

} // namespace mdm
