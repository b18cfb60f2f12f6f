#include "ask/tradeoff_options.hpp"

#include "ask/option_values.hpp"
#include "text/lines.hpp"

namespace mdm {
namespace {

void add_tolerances(const TradeoffTexts &asked, TradeoffOptions &o) {
  for (const std::string &part : between_commas(asked.tolerances.value_or("0,0.1,0.2,0.5,1,2,5"))) {
    const std::string text(trimmed(part));
    if (text.empty())
      throw InputError(option("tolerances") + ": a value is missing: write a comma between two values");
    if (text.find(':') != std::string::npos)
      throw InputError(option("tolerances") + ": " + in_quotes(text) + ": write values alone, and " +
                       option("kind") + " beside them");
    const AskedTolerance t =
        named("tolerances", asked.kind.value_or("retained") + ":" + text + (text.ends_with('%') ? "" : "%"),
              parse_tolerance);
    o.kind = t.kind;
    o.tolerances.push_back(t.percent);
  }
}

void add_budgets(const TradeoffTexts &asked, TradeoffOptions &o) {
  if (!asked.particles) {
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
  o.all_budgets = asked.particles == "all";
  if (!o.all_budgets)
    for (const std::string &text : between_commas(*asked.particles))
      o.budgets.push_back(natural("particles", text, 1));
}

} // namespace

const std::vector<OptionRow<TradeoffTexts>> TradeoffTexts::options = {
    {"kind",
     "TEXT",
     OptionKind::text,
     "what the tolerances are of: retained (percent in each class), passing (percent passing "
     "each sieve) or total (the sum of all deviations of percent retained)",
     &TradeoffTexts::kind,
     {"retained", "passing", "total"}},
    {"tolerances", "LIST", OptionKind::text,
     "tolerances in percentage points (0,0.1,0.2,0.5,1,2,5); 0 is the exact match",
     &TradeoffTexts::tolerances},
    {"particles", "LIST", OptionKind::text,
     "also the least tolerances with which so many particles suffice, and, of a specimen, the least size "
     "factors: a list as 100,1000, or all for 1, 2, 5, 10, 20, ...",
     &TradeoffTexts::particles},
    {"grid", "STEP", OptionKind::number,
     "the steps of those tolerances in percentage points, and of those factors (0.001)",
     &TradeoffTexts::grid}};

void TradeoffTexts::take_kind() {
  if (!particles || solve.tolerances.size() != 1 || !names_kind(solve.tolerances.front()))
    return;
  const std::string named = solve.tolerances.front();
  if (kind && kind != named)
    throw InputError(option("kind") + ": " + option("tolerance") + " says " + named +
                     ": leave one of them out");
  kind = named;
  solve.tolerances.clear();
}

TradeoffOptions TradeoffTexts::tradeoff_options() const {
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
