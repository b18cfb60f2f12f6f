#include "cli/budget_flags.hpp"

#include "cli/help.hpp"

namespace mdm::cli {

void BudgetFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "The question");
  command
      .add_option("--particles", particles,
                  "the least tolerance with which N particles suffice, of the kind that --tolerance names "
                  "without a value: retained (as without it), passing or total")
      ->type_name("N");
  command.add_option("--grid", grid, "the steps of that tolerance in percentage points (0.001)")
      ->type_name("STEP");
}

AskedQuestion BudgetFlags::question(const SolveFlags &others) const {
  return BudgetTexts::question(others, band_in_file);
}

} // namespace mdm::cli
