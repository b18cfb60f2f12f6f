#include "ask/crosscheck_options.hpp"
#include "crosscheck/other_answer.hpp"
#include "python/module.hpp"
#include "python/numbers.hpp"
#include "python/question.hpp"

#include <mdm/text/error.hpp>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace mdm::python {
namespace {

CrosscheckTexts crosscheck_texts(const Words &words) {
  CrosscheckTexts texts;
  static_cast<SolveTexts &>(texts) = solve_texts(words);
  take_words(words, CrosscheckTexts::options, texts);
  return texts;
}

/// Judges one solver's answers to one gradation.
class Judge {
public:
  Judge(Crosscheck problem, Rational size_tolerance)
      : problem_(std::move(problem)), size_tolerance_(std::move(size_tolerance)) {}

  /// \param answer  a line of JSON as `mdm crosscheck` reads it
  py::tuple judge(const std::string &answer) const {
    CrosscheckRow row;
    {
      const py::gil_scoped_release unlocked;
      row = problem_.judge(json_answer(answer), size_tolerance_);
    }
    return as_tuple(row);
  }

  /// The row of a solver that failed.
  py::tuple failed(const std::string &verdict, const std::string &reason) const {
    OtherAnswer none =
        failed_answer(problem_.gradation().id(), answer_verdict_named(verdict).value(), reason);
    return as_tuple(problem_.judge(none, 0));
  }

private:
  static py::tuple as_tuple(const CrosscheckRow &row) {
    const auto text = [](const std::optional<Rational> &r) {
      return r ? std::optional(to_string(*r)) : std::nullopt;
    };
    return py::make_tuple(
        row.id, std::string(name(row.verdict)), row.particles ? int_of(*row.particles) : py::none(),
        row.minimum ? int_of(*row.minimum) : py::none(), text(row.ratio), text(row.max_error), row.reason);
  }

  Crosscheck problem_;
  Rational size_tolerance_;
};

/// The question that a solver is judged on.
class JudgedQuestion {
public:
  JudgedQuestion(const std::map<std::string, std::string> &values, const std::vector<std::string> &tolerances)
      : JudgedQuestion(Words{values, tolerances}) {}

  Judge judge_of(const Gradation &g) const { return {question_.problem(g), size_tolerance_}; }

private:
  explicit JudgedQuestion(const Words &words)
      : question_(crosscheck_texts(words), band_of(words)),
        size_tolerance_(crosscheck_texts(words).most_size_error()) {}

  CrosscheckQuestion question_;
  Rational size_tolerance_;
};

} // namespace

void add_crosscheck(py::module_ &module) {
  py::class_<Judge>(module, "Judge").def("judge", &Judge::judge).def("failed", &Judge::failed);
  py::class_<JudgedQuestion>(module, "JudgedQuestion")
      .def(py::init<const std::map<std::string, std::string> &, const std::vector<std::string> &>())
      .def("judge_of", &JudgedQuestion::judge_of, py::call_guard<py::gil_scoped_release>());
}

} // namespace mdm::python
