#pragma once
/// \file
/// Names of sieves as laboratories spell them.

#include <mdm/number/rational.hpp>

#include <string_view>

namespace mdm {

/// Opening in mm of a sieve in a laboratory's table: a name of sieve_opening, or one of its other spellings
/// (`3/4-in.`, `1½"`, `1.5 in`, `U.S. No. 10`, `75 microns`), or two of them that name one sieve, one in
/// brackets (`No. 4 (4.75 mm)`), of which the metric one is taken. `point` is the decimal sign.
/// \throws InputError for what is none of these, and for two names of different sieves
Rational spelled_sieve_opening(std::string_view name, char point);

} // namespace mdm
