#pragma once
/// \file
/// Names of sieves.

#include <mdm/number/rational.hpp>

#include <optional>
#include <vector>

namespace mdm {

/// Opening in mm of a sieve name: ASTM E11 (`#200`, `3/8 in`, `3/8"`), Tyler with its prefix
/// (`Tyler 65 mesh`), or a metric opening (`1.18 mm`, `75 um`); 0 for `pan`. `point` is the decimal sign.
/// Tables and rules: proofs/certificate-format.md, sections 4 and 5.
/// \throws InputError for a name that is none of these
Rational sieve_opening(std::string_view name, char point = '.');

/// The ASTM E11 name of the sieve with an opening of `opening` mm, such as `3/8 in`, if there is one.
std::optional<std::string> astm_sieve_name(const Rational &opening);

/// The name of the ASTM E11 sieve of so many inches, such as `1-1/2 in` of 1.5, if there is one.
std::optional<std::string> astm_inch_name(const Rational &inches);

/// The openings in mm of all sieves of ASTM E11, or Tyler, that have a name, ascending.
std::vector<Rational> astm_openings();
std::vector<Rational> tyler_openings();

} // namespace mdm
