#include "ask/describe_options.hpp"
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
  DescribeTexts texts;
  take_words({values, {}}, DescribeTexts::options, texts);
  take_words({values, {}}, SoilTexts::options, texts.soil);
  const DescribeOptions options = texts.describe_options();
  return description_json(describe(texts.soil.with_pan(given), options), digits);
}

/// mdm-tradeoff-1, and the exception that ended it. \param own  the options that solving does not have
py::tuple tradeoff_of(const Gradation &g, const std::map<std::string, std::string> &values,
                      const std::vector<std::string> &asked_tolerances,
                      const std::map<std::string, std::string> &own, const py::object &progress) {
  const Words words{values, asked_tolerances};
  Listener listener(progress);
  std::string json;
  {
    const py::gil_scoped_release unlocked;
    TradeoffTexts asked;
    take_words({own, {}}, TradeoffTexts::options, asked);
    asked.solve = solve_texts(words);
    const bool is_empty = asked.tolerances == ""; // an empty list, which the program cannot be given
    if (is_empty)
      asked.tolerances.reset();
    TradeoffOptions options = asked.tradeoff_options();
    if (is_empty)
      options.tolerances.clear();
    options.progress = listener.call();
    json = tradeoff_json(mdm::tradeoff(g, asked.solve.question_of_both(band_of(words)).of(g), options));
  }
  return py::make_tuple(json, listener.error());
}

} // namespace

void add_reports(py::module_ &module) {
  module.def("describe", &describe_json);
  module.def("tradeoff", &tradeoff_of);
}

} // namespace mdm::python
