#pragma once
/// \file
/// One gradation of two: of sieves and a hydrometer, or of a sample and a part of it that was sieved for the
/// whole.

#include "gradation/regraded.hpp"

#include <optional>

namespace mdm {

/// A gradation with its name in the history.
struct NamedGradation {
  Gradation gradation;
  std::string name;
};

/// What is coarser than `at` (in the unit of `coarse`) as `coarse` has it, the rest as `fine` has it: its
/// masses times what passes the joint in `coarse` over what passes it in `fine`. The history says what is at
/// sizes that both have beside the joint, and which sizes of either were left out.
/// \throws InputError as regraded.hpp, and where nothing passes the joint in one of them
Regraded joined(const NamedGradation &coarse, const NamedGradation &fine, const Rational &at);

/// Composite sieving: `fine` is a part of what passes `at` in `coarse`, and all of it passes.
/// \param passed  the mass of all that passed, in the unit of the masses of `coarse`; nothing: as `coarse`
/// has it
/// \throws InputError as joined, where `fine` holds what cannot have passed, and where `passed` is missing or
/// says other than `coarse`
Regraded composed(const NamedGradation &coarse, const NamedGradation &fine, const Rational &at,
                  const std::optional<Rational> &passed);

} // namespace mdm
