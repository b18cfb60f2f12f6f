#pragma once
/// \file
/// A trade-off as text, JSON and CSV.

#include <mdm/match/tradeoff.hpp>

namespace mdm {

/// Tables for people.
std::string tradeoff_text(const Tradeoff &t);

/// One line of JSON, schema `mdm-tradeoff-1`, without a newline at its end.
std::string tradeoff_json(const Tradeoff &t);

/// kind,tolerance_percent,smallest_<unit>,lost_percent,particles,lower_bound,status, and size_factor where
/// there are such rows: the rows of one curve after the other. lost_percent is cut to 15 digits where it is
/// no decimal.
std::string tradeoff_csv(const Tradeoff &t);

/// The notes of the gradation, and from which size factor on a specimen is too narrow for its particles.
std::vector<std::string> tradeoff_notes(const Tradeoff &t);

} // namespace mdm
