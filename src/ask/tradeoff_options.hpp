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
  std::string kind = "retained";
  std::vector<std::string> tolerances; ///< in percentage points, with a percent sign or without
  std::vector<std::string> budgets;    ///< numbers of particles
  bool all_budgets = false;            ///< 1, 2, 5, 10, ...
  OptionText grid;

  /// The deadline counts from this call. \throws InputError naming the option where its value does not serve
  TradeoffOptions options() const;
};

} // namespace mdm
