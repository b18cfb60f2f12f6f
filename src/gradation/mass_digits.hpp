#pragma once
/// \file
/// Masses that went through floating point: what shows it, and what mends it.

#include <mdm/number/rational.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// r to the nearest decimal of `digits` >= 1 significant digits; a half goes away from zero.
Rational to_digits(const Rational &r, unsigned digits);

/// One unit of the last of `digits` significant digits of r; 0 of 0.
Rational digit_unit(const Rational &r, unsigned digits);

/// A note on masses that are the 16- or 17-digit prints of doubles beside short decimals, as differences and
/// sums in floating point give them (0.30000000000000004 beside 0.3), with both and with the `--round` that
/// gives the short ones; nothing where there are none. Cost: some nanoseconds for a short decimal.
std::optional<std::string> float_dust_note(const std::vector<Rational> &masses);

/// Takes the masses to `round` significant digits, if there is such a number.
/// \param of  what they are where they are not masses yet, but values that masses are differences of
/// \return the note on that, or else that on float dust, or nothing
std::optional<std::string> settle_digits(std::vector<Rational> &masses, std::optional<unsigned> round,
                                         std::string_view of = "");

/// The most significant digits, at least 3, to which `value` rounds to `whole`; nothing if there are none.
std::optional<unsigned> digits_that_give(const Rational &value, const Rational &whole);

} // namespace mdm
