#pragma once
/// \file
/// Numbers and sizes as messages show them.

#include <mdm/gradation/root_size.hpp>
#include <mdm/gradation/size_unit.hpp>

#include <string>

namespace mdm {

/// r as a message shows it: exact if it is short, else its first digits.
std::string shown(const Rational &r);
/// A size as a message shows it: a fraction as above; what is irrational by its first 15 digits, rounded.
std::string shown(const RootSize &x);
/// A size with its unit.
std::string shown(const Rational &size, SizeUnit unit);
/// r to the nearest hundredth.
std::string shown_hundredths(const Rational &r);

} // namespace mdm
