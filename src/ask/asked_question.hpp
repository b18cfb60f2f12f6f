#pragma once
/// \file
/// A question as its options state it, before the gradation is read.

#include "gradation/length.hpp"

#include <mdm/match/question.hpp>

#include <optional>
#include <string>

namespace mdm {

/// A specimen as the options state it.
struct AskedSpecimen {
  std::string shape, void_ratio;
};

/// A question whose lengths may have units of their own, or that of a gradation to come.
struct AskedQuestion {
  Question rest; ///< all but the lengths below; a law by table or sum is one of sizes in mm
  std::optional<Length> pan_size, cut_below;
  std::optional<AskedSpecimen> specimen;

  /// The question with its lengths in the gradation's unit.
  Question in(SizeUnit unit) const;
};

} // namespace mdm
