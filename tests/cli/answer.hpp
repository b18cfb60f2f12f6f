#pragma once
/// \file
/// An mdm-answer-1 as a test reads it, and what must hold in any of them.

#include "run.hpp"

#include <boost/multiprecision/gmp.hpp>
#include <nlohmann/json.hpp>

namespace cli_test {

using Json = nlohmann::json;
using Integer = boost::multiprecision::mpz_int;
using Rational = boost::multiprecision::mpq_rational;

/// The value of "12", "1.25" or "5/4".
Rational rational(const Json &text);
Rational cube(const Rational &x);
/// The quantities of all classes, ascending, separated by a space.
std::string quantities(const Json &answer);
/// The answer to a JSON question to solve.
Json solve_json(Arguments arguments, int exit_code = 0, const std::string &standard_input = "");
/// All that an exact match of spheres (without factors) owes its reader.
void check_match(const Json &answer);

} // namespace cli_test
