#pragma once
/// \file
/// The phi scale of sedimentology.

#include <mdm/number/rational.hpp>

namespace mdm {

/// 2^-phi mm: exact for an integer phi, else the nearest decimal of 15 significant digits (never a tie, the
/// value is irrational).
/// \throws InputError if |phi| > 1000
Rational phi_size(const Rational &phi);

} // namespace mdm
