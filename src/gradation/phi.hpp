#pragma once
/// \file
/// The phi scale of sedimentology.

#include <mdm/number/rational.hpp>

namespace mdm {

/// 2^(-phi root): the opening 2^-phi mm to the power `root`.
/// \pre |phi| <= 1000 and phi * root is whole
Rational phi_power(const Rational &phi, unsigned root);

/// \throws InputError if |phi| > 1000
void check_phi(const Rational &phi);

/// 2^-phi mm: exact for an integer phi, else the nearest decimal of 15 significant digits (never a tie, the
/// value is irrational).
/// \throws InputError if |phi| > 1000
Rational phi_size(const Rational &phi);

} // namespace mdm
