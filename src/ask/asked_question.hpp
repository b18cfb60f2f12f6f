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

  /// The question with its lengths in that unit, which those without one have.
  Question in(SizeUnit unit) const;
  /// The question to a gradation.
  /// \throws InputError where a length has no unit, and the gradation's file has inches
  Question of(const Gradation &g) const;
  /// The law of sizes in that unit.
  MassLaw law_in(SizeUnit unit) const;
};

} // namespace mdm
