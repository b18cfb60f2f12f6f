#include "cli/budget_flags.hpp"

#include "cli/help.hpp"
#include "cli/option_tables.hpp"

namespace mdm::cli {

void BudgetFlags::add_to(CLI::App &command) {
  const OptionGroup group(command, "The question");
  add_options(command, options, *this);
}

} // namespace mdm::cli
