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

  /// Makes the kind that --tolerance names without a value beside --particles, as solve has it, that of
  /// --kind.
  /// \throws InputError if --kind is another
  void take_kind();
  /// The deadline counts from this call. \throws InputError naming the option where its value does not serve
  TradeoffOptions tradeoff_options() const;
};

} // namespace mdm
