#pragma once

#include "certificate.hpp"
#include "gradation.hpp"

#include <string>

namespace mdm::checker {

/// True if the law is x^(a/b), not one by table or sum.
bool is_power(const Certificate &certificate);

/// f(x) of a law by table or sum, for x from 0 to the last node.
mpq_class value_of_law(const Certificate &certificate, const mpq_class &x);

/// The numbers in the place of openings, to the power d, of which the law is the power a/b (section 2).
/// Throws Refused where a law by table or sum does not fit the gradation.
Rationals measured_openings(const Gradation &gradation, const Certificate &certificate);

/// `by the table 0.5 mm: 1, 2 mm: 70` or `2*x^3 + 1/3*x^1, x in mm`.
std::string law_by_values(const Certificate &certificate, const std::string &unit);

} // namespace mdm::checker
