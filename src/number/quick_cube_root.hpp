#pragma once
/// \file
/// Cube roots in pairs of doubles: several times faster than in integers, where they decide.

#include <mdm/number/integer.hpp>

namespace mdm {

/// floor(10^places (n/d)^(1/3)) for n, d > 0, with 10^places or more below the root; nothing where doubles do
/// not decide it: the root times 10^places is above 2^96, or within about 2^-95 of itself of an integer
/// (Lemma 18).
std::optional<Integer> quick_cube_root(const Integer &n, const Integer &d, unsigned places);

/// False if n/d, for n, d > 0, is certainly not the cube of a fraction; true of 1 in 3,000 others.
bool may_be_cube(const Integer &n, const Integer &d);

} // namespace mdm
