#pragma once
/// \file
/// The window of scales of a match, and the scale that is chosen in it.

#include <mdm/match/solids.hpp>

#include <optional>

namespace mdm {

/// All scales (to the power b of the law) that make given quantities a match: above < S <= up_to, and S >=
/// s_0 where a volume of solids is asked for; s_0 is below `up_to` or equal to it.
struct Window {
  Rational above;
  Rational up_to;
  std::optional<StartScale> start;

  /// True if the scale of the asked volume is itself in the window: that volume can be had exactly. An
  /// irrational s_0 lies strictly between its bounds.
  bool start_is_feasible() const {
    return start && (start->exact() ? start->lo > above : start->lo >= above);
  }
};

enum class ScaleChoice {
  automatic, ///< the asked volume where the window has it, else robust
  robust,    ///< near the geometric middle: sizes far from the sieves on both sides
  upper      ///< the window's upper end
};

/// Robust: the simplest rational within 1/127 of the window's width above s* = max(sqrt(above * up_to), s_0)
/// (of the rest of the window, at s_0); half the upper end where the window starts at 0 and there is no s_0.
/// Automatic at an irrational s_0: a rational above it by at most 10^-digits of it.
Rational choose_scale(const Window &window, ScaleChoice choice, unsigned digits);

} // namespace mdm
