#pragma once
/// \file
/// The options of a budget of particles.

#include "cli/solve_flags.hpp"

#include <mdm/match/budget.hpp>

namespace mdm::cli {

/// A number of particles that chooses the tolerance.
struct BudgetFlags {
  std::optional<std::string> particles, grid;

  void add_to(CLI::App &command);
  bool is_asked() const { return particles.has_value(); }
  /// The budget; its kind is the one tolerance of the other options, or retained.
  /// \throws InputError naming the option where its value does not serve
  Budget budget(const SolveFlags &others) const;
  /// The question of the other options, without tolerance.
  /// \throws InputError likewise
  AskedQuestion question(const SolveFlags &others) const;
};

} // namespace mdm::cli
