#pragma once
/// \file
/// The options of a budget of particles.

#include "cli/solve_flags.hpp"

namespace mdm::cli {

/// A number of particles that chooses the tolerance or the size factor.
struct BudgetFlags : BudgetTexts {
  void add_to(CLI::App &command);
  bool is_asked() const { return particles.has_value(); }
};

} // namespace mdm::cli
