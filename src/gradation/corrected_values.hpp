#pragma once
/// \file
/// Two columns of a sheet of which one is of the whole sample and the other, in a part of its rows, is not.

#include <mdm/number/rational.hpp>

#include <vector>

namespace mdm {

// One number a row in each vector, of as many rows, and of one at least.

/// True where some masses are the same, not 0, and some are others, and the others are not the masses added
/// up from either end.
bool are_corrected_masses(const std::vector<Rational> &masses, const std::vector<Rational> &others);

/// True where percents are the same for the coarse sieves, of which one tells, and others for all finer ones.
bool are_corrected_percents(const std::vector<Rational> &sizes, const std::vector<Rational> &percents,
                            const std::vector<Rational> &others);

} // namespace mdm
