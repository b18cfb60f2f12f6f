#pragma once
/// \file
/// Problems of blends as JSON.

#include <mdm/blend/blend_problem.hpp>

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace mdm {

/// A problem with its name.
struct StatedBlendProblem {
  std::string id; ///< empty where it has none
  BlendProblem problem;
};

/// Reads the members that the problem has in mdm-blend-1, so that an answer is its own problem:
/// {"id": "a", "stockpiles": [{"name": "A", "passing": ["40", "100"], "least": "0", "most": "1", "cost":
/// "7"}, ...], "sieves": [{"size": "4", "least": "0", "most": "90", "target": null}, ...], "steps": "100",
/// "at_most": null, "aim": "cost"}. Sizes are in mm, passing in percent, shares from 0 to 1; numbers are
/// decimals or fractions p/q. What stockpiles and sieves have after their first two members (a sieve after
/// its size), and steps (100), at_most and aim (none) may be left out; so may moduli, which stockpiles have
/// beside `passing` where the problem limits some. Sieves may come in any order, with `passing` in the same.
/// \throws InputError that begins with the member
StatedBlendProblem read_blend_problem(std::string_view json);

/// A decimal or a fraction p/q. \param what  names it in messages
/// \throws InputError
Rational stated_number(const nlohmann::json &value, const std::string &what);

/// The id of a problem that cannot be read otherwise; empty where it has none.
std::string stated_blend_id(std::string_view json);

} // namespace mdm
