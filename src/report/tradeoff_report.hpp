#pragma once
/// \file
/// A trade-off as text, JSON and CSV.

#include <mdm/match/tradeoff.hpp>

namespace mdm {

/// Two tables for people.
std::string tradeoff_text(const Tradeoff &t);

/// One line of JSON, schema `mdm-tradeoff-1`, without a newline at its end.
std::string tradeoff_json(const Tradeoff &t);

/// kind,tolerance_percent,smallest_<unit>,lost_percent,particles,lower_bound,status: the rows of the first
/// curve, then those of the second. lost_percent is cut to 15 digits where it is no decimal.
std::string tradeoff_csv(const Tradeoff &t);

} // namespace mdm
