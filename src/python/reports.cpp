#include "cli/option_values.hpp"
#include "match/tradeoff.hpp"
#include "python/listener.hpp"
#include "python/module.hpp"
#include "python/question.hpp"
#include "report/description.hpp"
#include "report/tradeoff_report.hpp"

#include <mdm/number/decimal.hpp>
#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mdm::python {
namespace {

/// mdm-describe-1. \param limits  liquid and plastic limit, or empty
std::string describe_json(const Gradation &given, const std::vector<std::string> &limits,
                          const std::optional<std::string> &pan_size, bool extrapolate, unsigned digits) {
  const py::gil_scoped_release unlocked;
  DescribeOptions options;
  options.extrapolate = extrapolate;
  if (!limits.empty()) {
    options.limits = AtterbergLimits{
        cli::named("liquid_limit", limits.at(0), [](const std::string &t) { return parse_decimal(t); }),
        cli::named("plastic_limit", limits.at(1), [](const std::string &t) { return parse_decimal(t); })};
    classify_fines(*options.limits);
  }
  const Gradation g =
      pan_size ? given.with_pan_size(cli::length("pan_size", *pan_size).in(given.unit())) : given;
  return description_json(describe(g, options), digits);
}

TradeoffOptions tradeoff_options(const Words &words, const std::string &kind,
                                 const std::vector<std::string> &tolerances,
                                 const std::vector<std::string> &budgets, bool all_budgets) {
  TradeoffOptions o;
  for (const std::string &text : tolerances) {
    const AskedTolerance t = cli::named("tolerances", kind + ":" + text, parse_tolerance);
    o.kind = t.kind;
    o.tolerances.push_back(t.percent);
  }
  const bool has_budgets = !budgets.empty() || all_budgets;
  if (has_budgets && (words.is_tolerant() || words.has("at_most")))
    throw InputError("particles: it chooses tolerances: leave out tolerance, band and at_most");
  if (!has_budgets && words.has("grid"))
    throw InputError("grid: it is of particles: add it, or leave grid out");
  if (const std::string *const grid = words.find("grid"))
    o.grid = cli::positive("grid", *grid);
  o.all_budgets = all_budgets;
  for (const std::string &text : budgets)
    o.budgets.push_back(cli::natural("particles", text, 1));
  const SolveOptions options = options_of(words, false);
  o.limits = options.limits;
  o.limits.at_most = options.at_most;
  if (const std::string *const time = words.find("time_limit"))
    o.time_limit = cli::duration("time_limit", *time);
  return o;
}

/// mdm-tradeoff-1, and the exception that ended it.
py::tuple tradeoff_of(const Gradation &g, const std::map<std::string, std::string> &values,
                      const std::vector<std::string> &asked_tolerances, const std::string &kind,
                      const std::vector<std::string> &tolerances, const std::vector<std::string> &budgets,
                      bool all_budgets, const py::object &progress) {
  const Words words{values, asked_tolerances};
  Listener listener(progress);
  std::string json;
  {
    const py::gil_scoped_release unlocked;
    TradeoffOptions options = tradeoff_options(words, kind, tolerances, budgets, all_budgets);
    options.progress = listener.call();
    json = tradeoff_json(mdm::tradeoff(g, question_in(question_of_both(words), g.unit()), options));
  }
  return py::make_tuple(json, listener.error());
}

} // namespace

void add_reports(py::module_ &module) {
  module.def("describe", &describe_json);
  module.def("tradeoff", &tradeoff_of);
}

} // namespace mdm::python
