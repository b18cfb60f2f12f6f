#pragma once
/// \file
/// The options of a trade-off as texts.

#include "ask/solve_options.hpp"

#include <mdm/match/tradeoff.hpp>

#include <string>
#include <vector>

namespace mdm {

struct TradeoffTexts {
  SolveTexts solve; ///< what holds in all rows
  OptionText kind;
  OptionText tolerances; ///< in percentage points, with a percent sign or without, between commas
  OptionText particles;  ///< numbers of particles between commas, or `all` for 1, 2, 5, 10, ...
  OptionText grid;

  /// Those that solving does not have.
  static const std::vector<OptionRow<TradeoffTexts>> options;

  /// The deadline counts from this call. \throws InputError naming the option where its value does not serve
  TradeoffOptions tradeoff_options() const;
};

} // namespace mdm
