#include "cli/budget_flags.hpp"

#include "cli/help.hpp"
#include "cli/option_values.hpp"

#include <mdm/text/error.hpp>

namespace mdm::cli {
namespace {

/// The name of the kind without a value.
std::string kind_of(const SolveFlags &others) {
  return others.tolerances.empty() ? "retained" : others.tolerances.front();
}

} // namespace

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

Budget BudgetFlags::budget(const SolveFlags &others) const {
  if (others.tolerances.size() > 1)
    throw InputError("--particles: it chooses one tolerance: give one --tolerance, without a value");
  const std::string kind = kind_of(others);
  if (kind != "retained" && kind != "passing" && kind != "total")
    throw InputError("--tolerance: " + in_quotes(kind) +
                     ": --particles chooses the value: write retained, passing or total");
  if (others.band || others.at_most)
    throw InputError(std::string(others.band ? "--band" : "--at-most") +
                     ": it does not go with --particles: leave it out");
  Budget budget;
  budget.particles = natural("--particles", *particles, 1);
  budget.kind = parse_tolerance(kind + ":0%").kind;
  if (grid)
    budget.grid = positive("--grid", *grid);
  return budget;
}

AskedQuestion BudgetFlags::question(const SolveFlags &others) const {
  budget(others); // which refuses other tolerances
  SolveFlags with_value = others;
  with_value.tolerances = {kind_of(others) + ":0%"};
  AskedQuestion asked = with_value.question();
  asked.rest.tolerances.clear();
  return asked;
}

} // namespace mdm::cli
