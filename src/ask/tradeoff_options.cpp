#include "ask/tradeoff_options.hpp"

#include "ask/option_values.hpp"

namespace mdm {
namespace {

void add_tolerances(const TradeoffTexts &asked, TradeoffOptions &o) {
  for (const std::string &text : asked.tolerances) {
    const AskedTolerance t =
        named("tolerances", asked.kind + ":" + text + (text.ends_with('%') ? "" : "%"), parse_tolerance);
    o.kind = t.kind;
    o.tolerances.push_back(t.percent);
  }
}

void add_budgets(const TradeoffTexts &asked, TradeoffOptions &o) {
  if (asked.budgets.empty() && !asked.all_budgets) {
    if (asked.grid)
      throw InputError(option("grid") + ": it is of " + option("particles") + ": add it, or leave " +
                       option("grid") + " out");
    return;
  }
  if (asked.solve.is_tolerant() || asked.solve.at_most)
    throw InputError(option("particles") + ": it chooses tolerances: leave out " + option("tolerance") +
                     ", " + option("band") + " and " + option("at-most"));
  if (asked.grid)
    o.grid = positive("grid", *asked.grid);
  o.all_budgets = asked.all_budgets;
  for (const std::string &text : asked.budgets)
    o.budgets.push_back(natural("particles", text, 1));
}

} // namespace

TradeoffOptions TradeoffTexts::options() const {
  TradeoffOptions o;
  add_tolerances(*this, o);
  add_budgets(*this, o);
  const SolveOptions shared = solve.options();
  o.limits = shared.limits;
  o.limits.at_most = shared.at_most;
  if (solve.time_limit)
    o.time_limit = duration("time-limit", *solve.time_limit);
  return o;
}

} // namespace mdm
