#pragma once
/// \file
/// A trade-off as mdm tradeoff states it in JSON.

#include <mdm/match/tradeoff.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace mdm {

/// What an mdm-tradeoff-1 says.
struct StatedTradeoff {
  std::string id;
  std::string question; ///< what changes the problem, in words; empty: nothing
  SizeUnit unit = SizeUnit::mm;
  AskedTolerance::Kind kind = AskedTolerance::Kind::retained;
  std::vector<TradeoffRow> by_tolerance, by_sieve;
  std::vector<std::string> notes;
};

/// What tradeoff_json says of t.
StatedTradeoff stated(const Tradeoff &t);

/// True for a JSON text that says it is an mdm-tradeoff-1.
bool is_tradeoff(std::string_view content);

/// Reads what tradeoff_json writes. `file` precedes messages.
/// \throws InputError `file: what is wrong: what to do`
StatedTradeoff read_tradeoff(std::string_view content, const std::string &file);

} // namespace mdm
