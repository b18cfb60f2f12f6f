#include "ask/soil_options.hpp"
#include "ask/tradeoff_options.hpp"
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

/// mdm-describe-1.
std::string describe_json(const Gradation &given, const std::map<std::string, std::string> &values,
                          unsigned digits) {
  const py::gil_scoped_release unlocked;
  SoilTexts texts;
  take_words({values, {}}, SoilTexts::options, texts);
  const DescribeOptions options = texts.describe_options();
  return description_json(describe(texts.with_pan(given), options), digits);
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
    const TradeoffTexts asked{solve_texts(words), kind, tolerances, budgets, all_budgets, words.find("grid")};
    TradeoffOptions options = asked.options();
    options.progress = listener.call();
    json =
        tradeoff_json(mdm::tradeoff(g, asked.solve.question_of_both(band_of(words)).in(g.unit()), options));
  }
  return py::make_tuple(json, listener.error());
}

} // namespace

void add_reports(py::module_ &module) {
  module.def("describe", &describe_json);
  module.def("tradeoff", &tradeoff_of);
}

} // namespace mdm::python
